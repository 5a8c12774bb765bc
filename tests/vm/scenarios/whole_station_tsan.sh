# The scenario whole_station with the thread sanitizer, and with what it calls of the program. Its
# processor is faster, for what they add would leave it behind the devices.
like=whole_station
preset=tsan
programs='device_commands vm_check'
memory_mb=1024
instruction_shift=1

tractus() {
    exec device_commands "$@" # What is called in the background is to be the program itself.
}
