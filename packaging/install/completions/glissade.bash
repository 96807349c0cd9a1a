# bash completion of glissade. Options are those of its help.
_glissade() {
  local cur prev words cword
  _init_completion || return
  case $prev in
    --theme) mapfile -t COMPREPLY < <(compgen -W 'light dark' -- "$cur") ;;
    --stereo)
      mapfile -t COMPREPLY < <(compgen -W 'off anaglyph side-by-side top-bottom interlaced checkerboard quad-buffer left-eye right-eye' -- "$cur")
      ;;
    --language) mapfile -t COMPREPLY < <(compgen -W 'en fr' -- "$cur") ;;
    *)
      if [[ $cur == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_parse_help glissade)" -- "$cur")
      else
        _filedir
      fi
      ;;
  esac
} && complete -F _glissade glissade
