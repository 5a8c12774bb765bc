# The scenario whole_station with the thread sanitizer. Its processor is
# faster, for what they add would leave it behind the devices.
like=whole_station
preset=tsan
memory_mb=1024
instruction_shift=1
