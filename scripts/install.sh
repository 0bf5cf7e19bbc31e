# SPDX-License-Identifier: Apache-2.0
#
# Part of the launcher `trammel`: packages of the system and of Python. Every command needs those of
# scripts/packages.txt. The lines of packages_more.txt are `name  # what it brings`; tests, proofs
# and synthesis need these and those of packages_test.txt.

installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Of these lists, besides packages.txt.
packages() {
  local list
  for list in '' "${@/#/_}"; do sed 's/ .*//' "$root/scripts/packages$list.txt"; done
}

missing_packages() {
  local package
  while read -r package; do
    installed "$package" || printf '%s ' "$package"
  done < <(packages "$@")
}

is_debian() { command -v apt-get > /dev/null && command -v dpkg-query > /dev/null; }

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

apt() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 \
    -o Dpkg::Use-Pty=0 "$@" > /dev/null
}

# The packages of packages.txt, and of further lists that are named: the next build is configured
# with these.
install_packages() {
  local stamp hash missing
  stamp=$build/.packages${*:+_${*: -1}}
  hash=$(packages "$@" | sha256sum)
  if [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$hash" ]; then return; fi
  if [ -n "${TRAMMEL_NO_APT:-}" ]; then return; fi
  if ! is_debian; then
    say "this is not a Debian system; these must be there (Debian 12 names):"
    say "$(packages "$@" | tr '\n' ' ')"
    say "to continue with what is installed by hand: TRAMMEL_NO_APT=1"
    exit 3
  fi
  missing=$(missing_packages "$@")
  if [ -n "$missing" ]; then
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo > /dev/null; then
      say "missing: $missing"
      say "neither root nor sudo is available; as root: apt-get install $missing"
      exit 3
    fi
    say "installing by apt-get: $missing"
    # Fresh machines have no package lists, and old ones may point to files that are gone.
    # shellcheck disable=SC2086  # one word a package
    if ! apt install -y --no-install-recommends $missing 2> /dev/null; then
      say "updating the package lists"
      apt update || { say "apt-get update failed"; exit 3; }
      apt install -y --no-install-recommends $missing || {
        say "apt-get could not install: $missing"
        exit 3
      }
    fi
  fi
  if [ $# -gt 0 ]; then rm -f "$build/build.ninja"; fi
  mkdir -p "$build"
  printf '%s\n' "$hash" > "$stamp"
}

# Python tools: linter, register generator, prover... Optional: tests that need them are skipped.
install_python_tools() {
  local hash log=$build/venv.log
  hash=$(sha256sum < "$root/scripts/requirements.txt")
  if [ -f "$venv/.stamp" ] && [ "$(cat "$venv/.stamp")" = "$hash" ]; then return; fi
  say "installing Python tools in .venv"
  if python3 -m venv "$venv" > "$log" 2>&1 &&
    "$venv/bin/pip" install --quiet --disable-pip-version-check \
      -r "$root/scripts/requirements.txt" >> "$log" 2>&1; then
    printf '%s\n' "$hash" > "$venv/.stamp"
    return
  fi
  say "could not install the Python tools: $(tail -n 1 "$log")"
  if [ "${CI:-}" = true ]; then exit 3; fi
}

# Each package of .venv that has a user of its own, with its version there and that user.
python_packages() {
  local name pinned user version
  while IFS=$'\t' read -r name pinned user; do
    version=$(cd "$venv" && compgen -G "lib/python3*/site-packages/${name//[-.]/_}-*.dist-info" ||
      true)
    version=${version%.dist-info}
    version=${version##*-}
    [ -n "$version" ] || version="missing, $pinned is wanted"
    printf '%-30s%s\n' "$name" "$version (of .venv; $user)"
  done < <(sed -n 's/^\([^=# ]*\)==\([^ ]*\)  *# \(.*\)$/\1\t\2\t\3/p' \
    "$root/scripts/requirements.txt")
}

