# Bash completion for tractus: the program itself is asked for the possible words.

_tractus() {
    local typed=("${COMP_WORDS[@]:1:COMP_CWORD}") last=${COMP_WORDS[COMP_CWORD]} line i
    [ "$last" != = ] || last=
    for i in "${!typed[@]}"; do # Removes quotes, which the program never receives.
        typed[i]=${typed[i]#[\"\']}
        typed[i]=${typed[i]//\\/}
    done
    COMPREPLY=()
    while IFS= read -r line; do
        case $line in
        :files | :folders)
            compopt -o filenames
            [ "$line" = :files ] && line=-f || line=-d
            mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen "$line" -- "$last")
            ;;
        *)
            line=${line%%$'\t'*}
            [[ $last == [\"\']* ]] || printf -v line %q "$line"
            COMPREPLY+=("$line")
            ;;
        esac
    done < <("$1" complete -- "${typed[@]}" 2>/dev/null)
}
complete -F _tractus tractus
