# Scenario: whole_station with the thread sanitizer, which only a part of the program is built with. Its processor
# is faster, because the sanitizer's overhead would otherwise make it too slow for the devices.
like=whole_station
preset=tsan
programs='device_commands vm_check'
memory_mb=1024
instruction_shift=1

tractus() {
    exec device_commands "$@" # Replaces the shell, so that a background process is the program itself.
}
