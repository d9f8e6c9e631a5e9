# For ./demo and ./check, from the repository's root: prepare TARGET... installs missing packages, configures and builds.
# With sections="check" it installs the packages below the line "[check]" of packages.txt as well.

# The packages of packages.txt that dpkg does not know as installed.
missing_packages() {
  local wanted
  wanted=$(awk -v sections=" ${sections:-} " '
    /^\[/ { skip = !index(sections, " " substr($1, 2, length($1) - 2) " "); next }
    !skip { sub(/#.*/, ""); print }' packages.txt | xargs)
  comm -23 <(tr ' ' '\n' <<<"$wanted" | sort -u) \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p' | sort -u)
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "neither root nor sudo: run this as root first: $*" >&2
    return 1
  fi
}

install_packages() {
  local missing
  mapfile -t missing < <(missing_packages)
  [ "${#missing[@]}" -gt 0 ] || return 0
  echo "installing ${#missing[@]} packages: ${missing[*]}"
  as_root apt-get update -qq
  as_root env DEBIAN_FRONTEND=noninteractive DEBCONF_NOWARNINGS=yes \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

prepare() {
  install_packages
  [ -f build/release/build.ninja ] || cmake --preset release
  cmake --build build/release --target "$@" --parallel "$(nproc)"
}
