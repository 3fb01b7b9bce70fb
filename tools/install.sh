#!/usr/bin/env bash
# Installs what a bare Debian 12 lacks for a job: tools/install.sh demo|build|test|bench|lint|...
# Nothing happens, and quickly, if everything is there. A package whose command is there by other means
# (node from elsewhere, say) is not installed either. Needs root or sudo only if something lacks.
set -euo pipefail

compile=(g++ cmake ninja-build libtbb-dev libeigen3-dev libfast-float-dev libfmt-dev libcli11-dev
         nlohmann-json3-dev libexpected-dev libosd-dev libembree-dev libpng-dev
         libcgal-dev libnanoflann-dev)
testing=(libgtest-dev librapidcheck-dev libvalijson-dev python3)
pages=(nodejs npm)                              # the frame of HTML reports
studio=(g++ cmake ninja-build libeigen3-dev libfast-float-dev libfmt-dev libexpected-dev
        emscripten node-acorn)                 # WebAssembly, from the libraries' headers
rivals=(libbenchmark-dev libopenmesh-dev libtinyobjloader-dev libsuitesparse-dev libassimp-dev)

job=${1:?usage: tools/install.sh demo|build|web|studio|test|papers|bench|counts|format|lint|ci}
case $job in
  demo | build) packages=("${compile[@]}") ;;
  web) packages=("${pages[@]}") ;;
  studio) packages=("${pages[@]}" "${studio[@]}") ;;
  test) packages=("${compile[@]}" "${testing[@]}" "${pages[@]}" "${studio[@]}" chromium) ;;
  papers) packages=("${compile[@]}" "${testing[@]}") ;;
  bench) packages=("${compile[@]}" "${rivals[@]}") ;;
  counts) packages=("${compile[@]}" python3 valgrind) ;;
  format) packages=(clang-format) ;;
  lint) packages=("${compile[@]}" "${testing[@]}" "${pages[@]}" clang-format clang-tidy) ;;
  ci) packages=("${compile[@]}" "${testing[@]}" "${pages[@]}" "${studio[@]}" chromium clang libclang-rt-dev clang-format clang-tidy
                ccache valgrind) ;;
  *)
    echo "tools/install.sh: there is no job '$job'" >&2
    exit 1
    ;;
esac

if ! command -v dpkg-query > /dev/null || ! command -v apt-get > /dev/null; then
  echo "This is not a Debian system, so nothing is installed for you. Surpass needs, under the" \
       "names that your system gives them: ${packages[*]}" >&2
  exit 0
fi

present=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${packages[@]}" 2> /dev/null |
  sed -n 's/ installed$//p') || true
has_command() {
  case $1 in
    nodejs) command -v node ;;
    npm | chromium) command -v "$1" ;;
    *) false ;;
  esac > /dev/null
}
missing=()
for package in "${packages[@]}"; do
  [[ $'\n'$present$'\n' == *$'\n'$package$'\n'* ]] || has_command "$package" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo > /dev/null; then
    echo "Please have these packages installed, then try again: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
install_missing() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --no-install-recommends "${missing[@]}" > "$log" 2>&1
}

echo "Installing for 'make $job': ${missing[*]}" >&2
# Lists that are absent or old are the usual reason for a first failure.
if ! install_missing; then
  "${as_root[@]}" apt-get update > "$log" 2>&1 && install_missing || {
    cat "$log" >&2
    echo "The packages could not be installed; the reason is above." >&2
    exit 1
  }
fi
