#!/usr/bin/env bash
# Gradescope runs this once, as root, when it builds the image: installs a compiler and what else is
# missing, and builds the judge.
set -euo pipefail
tumble=$(cd "$(dirname "$0")" && pwd)/tumble
export DEBIAN_FRONTEND=noninteractive
apt-get -q update
apt-get -q install -y --no-install-recommends ca-certificates g++ cmake ninja-build

# Ubuntu 22.04 has an older compiler and an older CMake than the judge needs.
if apt-cache show g++-12 >/dev/null 2>&1 && [ "$(g++ -dumpversion | cut -d. -f1)" -lt 12 ]; then
  apt-get -q install -y --no-install-recommends g++-12
  update-alternatives --install /usr/bin/g++ g++ /usr/bin/g++-12 100
  update-alternatives --install /usr/bin/c++ c++ /usr/bin/g++-12 100
fi
version=$(cmake --version | sed -n '1s/[^0-9]*//p')
if [ "$(printf '3.25\n%s\n' "$version" | sort -V | head -n 1)" != 3.25 ]; then
  apt-get -q install -y --no-install-recommends python3-pip
  pip3 install 'cmake>=3.25,<4'
fi

"$tumble/tumble" prepare
# Students' code runs as another user and behind walls; this is one more.
chmod -R go= "$tumble/solutions" "$tumble/tests"
