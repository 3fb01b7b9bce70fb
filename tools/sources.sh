#!/usr/bin/env bash
# The C++ files of the project, one a line.
cd "$(dirname "$0")/.." && find apps bench bindings examples include src tests \
  \( -name '*.cpp' -o -name '*.hpp' \) 2> /dev/null | sort
