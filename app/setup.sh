# Functions shared by app/run and tests/run. Source it from the root of the repository.

# Prints the packages in one section of app/packages.
packages_of() {
    sed -n "/^\[$1\]/,/^\[/{/^[a-z]/p}" app/packages
}

# True if a package is installed, or if what it provides is there: npm also comes with other builds of Node.js.
have_package() {
    case $1 in
    npm) command -v npm >/dev/null ;;
    *) [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ] ;;
    esac
}

# Installs missing packages of the given sections; asks for root only if something is missing.
install_packages() {
    local part package missing=()
    for part in "$@"; do
        for package in $(packages_of "$part"); do
            have_package "$package" || missing+=("$package")
        done
    done
    [ ${#missing[@]} -gt 0 ] || return 0

    local root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "error: these packages are missing and need root to install: ${missing[*]}" >&2
            return 1
        fi
        root=(sudo)
    fi
    echo "Installing: ${missing[*]}"
    "${root[@]}" apt-get update -qq
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# Makes builds that are configured from now on keep what they compile, if ccache is installed: a build of the same
# sources in any folder takes it from there.
use_ccache() {
    command -v ccache >/dev/null || return 0
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
    export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=yes CCACHE_SLOPPINESS=pch_defines,time_macros
}
use_ccache

# Filters the output of ninja or ctest: instead of lines about successful steps it prints, every ten seconds, how
# many steps are done and the estimated remaining time.
#   show_progress NOUN
show_progress() {
    local noun=$1 begun=$SECONDS shown=$SECONDS line done all left
    while IFS= read -r line; do
        if [[ $line =~ ^\ *\[?([0-9]+)/([0-9]+)[]\ ] ]]; then
            done=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]}
            if ((SECONDS - shown >= 10 && done < all)); then
                left=$(((SECONDS - begun) * (all - done) / done))
                printf '   %d of %d %s, about %d:%02d left\n' "$done" "$all" "$noun" $((left / 60)) $((left % 60))
                shown=$SECONDS
            fi
            case $line in '['* | *' Passed '*) continue ;; esac
        fi
        case $line in *'no work to do'* | 'ninja: Entering'* | *' Start '*) continue ;; esac
        printf '%s\n' "$line"
    done
}

# Configures a preset if necessary, and builds the given targets, or all.
build_preset() {
    local preset=$1
    shift
    if [ ! -f "build/$preset/build.ninja" ]; then
        cmake --preset "$preset" "${cmake_options[@]}" --log-level=WARNING >/dev/null
    fi
    ninja -C "build/$preset" "$@" | show_progress "steps of the build"
}

cmake_options=() # Options that the caller passes to cmake in addition to the preset.
