# The scenario gadget_unplugged where udevd tells of arrivals.
like=gadget_unplugged
udev=yes
