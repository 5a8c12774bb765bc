# Functions for Debian's own kernel, as users have it. Sourced by tests/vm/prepare.

kernel=build/vm/kernel # Contains vmlinux, release (its version), lib/modules.

# Folders that may contain modules for the scenarios' devices.
kernel_module_folders=(crypto drivers/{block,char,gpio,hid,i2c,iio,input,leds,power,spi,usb,virtio} fs/configfs lib)

# Prints the name of the current package of Debian's kernel for PCs, according to the given package lists.
#   kernel_package APT_OPTION...
kernel_package() {
    apt-cache "$@" depends linux-image-amd64 | sed -n 's/^ *Depends: //p' | head -n 1
}

# Downloads the kernel's package into a folder. If the system has no package lists, it fetches lists of its own,
# which does not need root.
download_kernel() {
    local folder=$1 lists=$PWD/build/vm/lists package
    local options=(-q -o APT::Sandbox::User=root)
    package=$(kernel_package "${options[@]}")
    if [ -z "$package" ]; then
        mkdir -p "$lists"/partial "$lists"/archives/partial
        options+=(-o "Dir::State::lists=$lists" -o "Dir::Cache=$lists" -o Debug::NoLocking=1)
        apt-get "${options[@]}" update >/dev/null
        package=$(kernel_package "${options[@]}")
    fi
    (cd "$folder" && apt-get "${options[@]}" download "$package" >/dev/null)
}

# Extracts the compressed kernel from the bootable file: under emulation, unpacking takes longer than booting, so it
# is unpacked beforehand. The offsets are those of the boot protocol (the kernel's Documentation/x86/boot.rst:
# setup_sects, payload_offset, payload_length).
cut_out_kernel() {
    local image=$1
    number_at() { od -An -v -t "u$2" -j "$1" -N "$2" "$image" | tr -d ' '; }
    local setup_bytes=$((($(number_at 0x1f1 1) + 1) * 512))
    dd if="$image" bs=64K iflag=skip_bytes,count_bytes status=none \
        skip=$((setup_bytes + $(number_at 0x248 4))) count="$(number_at 0x24c 4)" \
        | xz -dc --single-stream # The payload is followed by its length, which is ignored.
}

# Makes build/vm/kernel unless it exists: about 71 MB of download, 66 MB unpacked.
fetch_kernel() {
    [ "$(cat "$kernel/folders" 2>/dev/null)" = "${kernel_module_folders[*]}" ] && return
    local part=$kernel.part
    rm -rf "$part"
    mkdir -p "$part"
    download_kernel "$part" || return 1
    dpkg-deb --fsys-tarfile "$part"/*.deb | tar -x -C "$part" --wildcards './boot/vmlinuz-*' \
        './lib/modules/*/modules.*' "${kernel_module_folders[@]/#/./lib/modules/*/kernel/}"
    (cd "$part/lib/modules" && echo *) >"$part/release"
    cut_out_kernel "$part"/boot/vmlinuz-* >"$part/vmlinux" || return
    depmod --basedir "$part" "$(<"$part/release")" || return
    rm -rf "$part"/*.deb "$part/boot"
    echo "${kernel_module_folders[*]}" >"$part/folders"
    rm -rf "$kernel"
    mv "$part" "$kernel"
}
