# Debian's own kernel, as an ordinary user gets it. For tests/vm/prepare to source.

kernel=build/vm/kernel # vmlinux, release (its version), lib/modules.

# The folders of modules in which a device's may lie.
kernel_module_folders=(crypto drivers/{block,char,gpio,hid,i2c,input,leds,power,spi,usb,virtio} fs/configfs lib)

# Prints the name of the package that Debian's kernel for PCs is now, as these lists have it.
#   kernel_package APT_OPTION...
kernel_package() {
    apt-cache "$@" depends linux-image-amd64 | sed -n 's/^ *Depends: //p' | head -n 1
}

# Downloads the kernel's package into a folder. Where the system has no lists of packages, which
# nobody but root could fetch, it fetches lists of its own.
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

# Prints the kernel proper, which the bootable file has within, packed: to boot it as it is saves
# unpacking it under emulation, which takes longer than booting. The offsets are those of the boot
# protocol (the kernel's Documentation/x86/boot.rst: setup_sects, payload_offset, payload_length).
cut_out_kernel() {
    local image=$1
    number_at() { od -An -v -t "u$2" -j "$1" -N "$2" "$image" | tr -d ' '; }
    local setup_bytes=$((($(number_at 0x1f1 1) + 1) * 512))
    dd if="$image" bs=64K iflag=skip_bytes,count_bytes status=none \
        skip=$((setup_bytes + $(number_at 0x248 4))) count="$(number_at 0x24c 4)" \
        | xz -dc --single-stream # Behind it stands its length.
}

# Makes build/vm/kernel, if it is not there: some 71 MB of download, 66 MB unpacked.
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
