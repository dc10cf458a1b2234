#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fails if a source does not begin with its licence: GPL-3.0-or-later in meshing/, MIT everywhere else.
set -euo pipefail
sources=$(dirname "$0")/sources.sh
failures=0
checked=0
while IFS= read -r file; do
  licence=MIT
  if [[ $file == meshing/* ]]; then licence=GPL-3.0-or-later; fi
  checked=$((checked + 1))
  if ! head -n 2 "$1/$file" | grep -qE "SPDX-License-Identifier: $licence( |\$)"; then
    echo "$file: no line 'SPDX-License-Identifier: $licence' at its top"
    failures=$((failures + 1))
  fi
done < <("$sources" "$1" | grep -E '\.(h|cpp|sh|cmake|py|toml)$|(^|/)CMakeLists\.txt$|^bake$|^\.ci/run$|^packages/' | grep -v '/corpus_')
echo "$checked files checked"
((failures == 0 && checked > 0))
