# SPDX-License-Identifier: LGPL-2.1-or-later
# Completion of the softgrain command line for bash. `cmake --install` puts it where bash-completion finds it; without
# that, `source contrib/softgrain.bash`. Commands, options and choices are taken from the help of the program itself, once
# per shell, so that they are always those of the installed version.

declare -gA _softgrain_known=()

# Keeps the output of a command: _softgrain_ask PROGRAM WORDS...; the answer is in $_softgrain_answer.
_softgrain_ask() {
  local key="$*"
  if [ -z "${_softgrain_known[$key]+set}" ]; then
    _softgrain_known[$key]=$("$@" 2>/dev/null)
  fi
  _softgrain_answer=${_softgrain_known[$key]}
}

# The names below "Subcommands:" in a help text.
_softgrain_commands() {
  awk '/^Subcommands:/ { inside = 1; next } inside && /^  [a-z]/ { print $1; next } inside && !/^ / { exit }' <<<"$1"
}

_softgrain() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local names='' command='' i
  COMPREPLY=()

  # The command: one word, two for `figures`.
  for ((i = 1; i < COMP_CWORD; i++)); do
    [[ ${COMP_WORDS[i]} == -* ]] || { command=${COMP_WORDS[i]} && break; }
  done
  local words=("$program")
  [ -z "$command" ] || words+=("$command")
  if [ "$command" = figures ] && ((COMP_CWORD > i + 1)); then
    words+=("${COMP_WORDS[i + 1]}")
  fi
  _softgrain_ask "${words[@]}" --help
  local help=$_softgrain_answer

  case "$previous" in
    --model) names='mpm bpm' ;;
    --format) names='prm json md' ;;
    --measures)
      _softgrain_ask "$program" measure --list
      names=$(awk '{ print $1 }' <<<"$_softgrain_answer")
      ;;
    --*)
      # Python's help shows a choice as {a,b,c}.
      names=$(sed -n "s/^ *$previous {\([^}]*\)}.*/\1/p" <<<"$help" | head -1 | tr ',' ' ')
      ;;
  esac
  if [ -z "$names" ]; then
    if [[ $word == -* ]]; then
      # Lines that begin with an option; the text below may name options of other commands.
      names=$(sed -nE 's/^ +((-[a-zA-Z], ?)?--[a-z-]+).*/\1/p' <<<"$help" | grep -oE -- '--?[a-z][a-z-]*' | sort -u)
    else
      names=$(_softgrain_commands "$help")
    fi
  fi
  if [ -n "$names" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$names" -- "$word")
  fi
  [ ${#COMPREPLY[@]} -eq 0 ] || return 0

  # Files and folders.
  case "$previous" in --set | --threads | --model | --format | --measures) return 0 ;; esac
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$word")
  local ending file
  case "$command$previous" in
    run--restart) ending='.h5' ;;
    run* | check*) ending='.prm .json' ;;
    study*) ending='.prm' ;;
    *) ending='.png .svg .pdf .csv .html' ;;
  esac
  while IFS= read -r file; do
    case " $ending " in *" .${file##*.} "*) COMPREPLY+=("$file") ;; esac
  done < <(compgen -f -- "$word")
}

complete -F _softgrain softgrain
