# Sourced by samples/run.sh and tests/run.sh: installs the Debian packages that are missing.
# Does nothing, and asks nothing of the network, when all of them are there.

limn_build_packages=(
    g++ cmake ninja-build
    libvulkan-dev mesa-vulkan-drivers                        # the device: lavapipe where no GPU is
    glslang-dev glslang-tools spirv-tools libspirv-cross-c-shared-dev   # shaders
    libxxhash-dev libglm-dev libyaml-cpp-dev libpng-dev libtinygltf-dev nlohmann-json3-dev
    libembree-dev                                            # what a click hits
    libassimp-dev libtiff-dev libstb-dev libopenexr-dev      # models and pictures of Unity projects
    graphviz gnuplot-nox                                     # `limn explain --graph` and `limn report` draw with them
)
limn_test_packages=(
    libgtest-dev libgmock-dev vulkan-validationlayers
    python3-jsonschema python3-yaml                          # `limn schema` is validated
    chromium-headless-shell                                  # the page of `limn report` is looked at
    doxygen                                                  # the pages of the public headers: a warning fails
    patch                                                    # a guide in samples/guide changes a file with it
    ccache mold                                              # the next build is quicker; found by CMake
)

limn_install_missing() {
    local missing=() package
    for package in "$@"; do
        if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
            missing+=("$package")
        fi
    done
    [ ${#missing[@]} -gt 0 ] || return 0

    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "limn needs these Debian packages: ${missing[*]}" >&2
            echo "Install them as root, or install sudo, then run this again." >&2
            exit 3
        fi
        as_root=(sudo)
    fi
    echo "Installing Debian packages: ${missing[*]}" >&2
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}
