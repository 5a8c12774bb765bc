# Scenario: whole_station with address and undefined-behaviour sanitizers. Its processor is faster, because the
# sanitizers' overhead would otherwise make it too slow for the devices.
like=whole_station
preset=asan
memory_mb=1024
instruction_shift=1
