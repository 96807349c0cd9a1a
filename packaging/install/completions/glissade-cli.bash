# bash completion of glissade-cli. Commands, options and their values are those of its help.

# _glissade_cli_values COMMAND OPTION: the values that the help of the option lists, one per line. Options of the
# program itself are taken behind a command, too.
_glissade_cli_values() {
  { glissade-cli "$1" --help && glissade-cli --help; } 2>/dev/null | sed -nE \
    -e "s/^ +$2 TEXT:\\{([^}]*)\\}.*/\\1/p" \
    -e "s/^ +$2 .*Planner: ([^(]*).*/\\1/p" | tr ', ' '\n\n'
}

_glissade_cli() {
  local cur prev words cword
  _init_completion || return

  local command=${words[1]}
  if [ "$cword" -eq 1 ]; then
    local commands
    commands=$(glissade-cli --help 2>/dev/null | awk '/^Subcommands:/ { inside = 1; next } inside { print $1 }')
    mapfile -t COMPREPLY < <(compgen -W "$commands --help --version --language" -- "$cur")
  elif [[ $cur == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_parse_help glissade-cli "$command --help") --language" -- "$cur")
  elif [[ $prev == --* ]] && mapfile -t COMPREPLY < <(compgen -W "$(_glissade_cli_values "$command" "$prev")" -- "$cur") &&
    [ ${#COMPREPLY[@]} -gt 0 ]; then
    return
  else
    _filedir
  fi
} && complete -F _glissade_cli glissade-cli
