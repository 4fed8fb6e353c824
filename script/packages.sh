# need_packages PACKAGE...: install with apt those that are missing, as root or through sudo.
# Sourced by the other scripts; touches the package lists only if something is missing.
need_packages() {
    local missing=() package as_root=()
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' ||
            missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "missing packages: ${missing[*]}; install them as root, or install sudo" >&2
            return 1
        fi
        as_root=(sudo)
    fi
    echo "installing: ${missing[*]}"
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq update
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y \
        --no-install-recommends -o Dpkg::Use-Pty=0 install "${missing[@]}" >/dev/null
}

# What the program grit is built from, and what its tests and those of everything else are.
program_packages=(g++ cmake ninja-build pkg-config libeigen3-dev libcli11-dev libtomlplusplus-dev libfmt-dev
    libceres-dev libzip-dev libpugixml-dev libjs-chart.js)
test_packages=("${program_packages[@]}" gcc libc6-dev ccache binutils libgtest-dev libboost-dev libbenchmark-dev
    gfortran git gnuplot-nox abigail-tools clang-format lammps liblammps-dev libopenmpi-dev make openmpi-bin
    python3-dev python3-numpy python3-pip python3-setuptools python3-wheel python3-venv pybind11-dev)
