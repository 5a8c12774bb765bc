# Fish completion for tractus: the program itself is asked for the possible words.

function __tractus_complete
    set -l typed (commandline --current-process --tokenize --cut-at-cursor)
    set -l last "$(commandline --current-token --cut-at-cursor)"
    for line in ($typed[1] complete -- $typed[2..] $last 2>/dev/null)
        switch $line
            case :files
                __fish_complete_path $last
            case :folders
                __fish_complete_directories $last
            case '*'
                echo $line
        end
    end
end

complete --command tractus --no-files --arguments '(__tractus_complete)'
