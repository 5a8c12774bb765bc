# The machine boots, our program runs in it, and without devices it says so.
modules='uhid hid-generic'

guest() {
    tractus --version
    tractus devices | tee devices
    grep -q 'No HID device is plugged in' devices
}
