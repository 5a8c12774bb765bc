# Scenario: the machine boots, the program runs in it, and it reports that there are no devices.
modules='uhid hid-generic'

guest() {
    tractus --version
    tractus devices | tee devices
    grep -q 'No HID device is plugged in' devices
}
