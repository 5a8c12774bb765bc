# The scenario whole_station with address and undefined-behaviour sanitizers. Its processor is
# faster, for what they add would leave it behind the devices.
like=whole_station
preset=asan
memory_mb=1024
instruction_shift=1
