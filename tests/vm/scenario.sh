# Functions that read scenarios, sourced by tests/vm/boot and tests/vm/prepare.

# Prints the files of a scenario: that of the scenario that it is derived from, if there is one, then its own.
#   scenario_files SCENARIO
scenario_files() {
    local file=tests/vm/scenarios/$1.sh like
    like=$(sed -n 's/^like=//p' "$file")
    [ -z "$like" ] || echo "tests/vm/scenarios/$like.sh"
    echo "$file"
}

# Reads a scenario's variables and functions into this shell, over their defaults.
#   read_scenario SCENARIO
read_scenario() {
    local file
    modules='' programs='tractus vm_check' files='' corpus='' preset=release
    memory_mb=512 virtual_time=yes instruction_shift=3 udev=no qemu='' limit_s=120
    for file in $(scenario_files "$1"); do source "$file"; done
}

# Prints the preset in which a program is built; the judging program is always the release build.
#   preset_of PROGRAM
preset_of() {
    if [ "$1" = vm_check ]; then echo release; else echo "$preset"; fi
}
