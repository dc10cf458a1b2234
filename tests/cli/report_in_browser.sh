#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A browser opens the report from the file system: it asks for nothing else, has nothing to complain about, and the page fits a phone.
# Usage: report_in_browser.sh <bake program>. Skipped (77) where chromium is not installed.
set -euo pipefail
command -v chromium >/dev/null || exit 77

bake=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$bake" report --out report.html
fail() { echo "FAILED: $*" >&2; exit 1; }

# Prints the page as the browser understands it; further options come first.
browse() {
  HOME=$folder timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --disable-background-networking \
    --disable-component-update --no-first-run --user-data-dir="$folder/profile" --virtual-time-budget=3000 --dump-dom "$@" 2>log ||
    fail "chromium: $(tail -n 3 log)"
}

# The net log has every URL that is asked for; the page's own file and what stands in it are all.
browse --window-size=390,844 --enable-logging=stderr --log-net-log="$folder/net.json" "file://$folder/report.html" >dom.html
grep -q '<h1>' dom.html || fail "the page is empty"
if grep 'CONSOLE' log; then fail "the browser complains"; fi
if grep -o '"url":"https\?://[^"]*"' net.json | grep -v -e 'google' -e 'gvt1'; then fail "something was asked for"; fi

# A phone is 360 wide; a window of chromium cannot be.
cat >phone.html <<'HTML'
<title>not measured</title>
<iframe src="report.html" style="width:360px;height:800px;border:0"
  onload="document.title = 'wide ' + this.contentDocument.documentElement.scrollWidth"></iframe>
HTML
browse --hide-scrollbars --allow-file-access-from-files "file://$folder/phone.html" >phone_dom.html
grep -q '<title>wide 360</title>' phone_dom.html || fail "on a phone: $(grep -o '<title>.*</title>' phone_dom.html), wanted 360"
