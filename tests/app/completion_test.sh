#!/usr/bin/env bash
# Completes command lines as bash does on Tab, and compares with what is expected.
# usage: completion_test.sh PROGRAMS_FOLDER COMPLETIONS_FOLDER
set -uo pipefail
export PATH=$1:$PATH
# shellcheck disable=SC1091
source /usr/share/bash-completion/bash_completion
source "$2/glissade-cli.bash"
source "$2/glissade.bash"
failed=0

# expect "COMPLETIONS" WORD...: the last word is completed.
expect() {
  local wanted=$1 function
  shift
  function=_${1//-/_}
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  COMP_LINE=$*
  COMP_POINT=${#COMP_LINE}
  COMPREPLY=()
  "$function"
  [ "${COMPREPLY[*]}" = "$wanted" ] && return
  echo "'$*' completes to '${COMPREPLY[*]}', not to '$wanted'"
  failed=1
}

expect "sweep" glissade-cli sw
expect "--alpha" glissade-cli plan --al
expect "--contact-samples --contact-distance --contact-radius --contact-gap" glissade-cli plan --contact-
expect "gts1 gts2 gts" glissade-cli plan --strategy gts
expect "on off" glissade-cli plan --fits ""
expect "--language" glissade-cli plan --lang
expect "en fr" glissade-cli plan --language ""
expect "--required-clearance" glissade --req
expect "dark" glissade --theme d
expect "side-by-side" glissade --stereo s
exit $failed
