# Scenario: gadget_unplugged with udevd, which announces arriving devices.
like=gadget_unplugged
udev=yes
