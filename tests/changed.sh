# Functions shared by tests/alone and tests/tidy, which check changed files. Source it from the root of the
# repository.

# Prints the commit to compare with; nothing if there is none before HEAD, or if all files are requested.
#   base_commit RECORD [COMMIT | --all]
# The file RECORD names a commit in which everything has been checked. It is used if it is later than the commit at
# which HEAD left origin/main.
base_commit() {
    local record=$1 left looked_at
    shift
    if [ "${1-}" = --all ]; then
        return
    elif [ $# -gt 0 ]; then
        git merge-base HEAD "$1"
        return
    fi
    left=$(git merge-base HEAD origin/main 2>/dev/null) || left=
    if [ "$left" = "$(git rev-parse HEAD)" ]; then left=; fi
    looked_at=$(cat "$record" 2>/dev/null) || looked_at=
    if [ -n "$looked_at" ] && git merge-base --is-ancestor "$looked_at" HEAD 2>/dev/null \
        && { [ -z "$left" ] || git merge-base --is-ancestor "$left" "$looked_at"; }; then
        echo "$looked_at"
    else
        echo "$left"
    fi
}

# Prints a source without comments and blanks.
code_of() { g++ -fpreprocessed -dD -E -P -x c++ - 2>/dev/null | tr -d '[:space:]'; }

# Prints the files that differ from a commit, committed or not, except sources that differ only in comments.
changed_since() {
    local name
    git diff --name-only "$1" | while read -r name; do
        case $name in
        *.h | *.cpp)
            if [ -e "$name" ] && git cat-file -e "$1:$name" 2>/dev/null \
                && cmp -s <(git show "$1:$name" | code_of) <(code_of <"$name"); then
                continue
            fi
            ;;
        *.clang-tidy)
            if cmp -s <(git show "$1:$name" | grep -v '^ *#') <(grep -v '^ *#' "$name"); then continue; fi
            ;;
        esac
        echo "$name"
    done
    git ls-files --others --exclude-standard
}

# Prints the files, changed since a commit, that a build or its tests can depend on: all but the manual, notes, and
# scripts that only drive the finished program.
build_inputs_changed_since() {
    changed_since "$1" | grep -vE '\.md$|\.checked$|^(app/manual|firmware-notes|\.ci|tests/manual|tests/bench)/' \
        | grep -vE '^tests/(run|one|alone|tidy|changed\.sh|app/window/[a-z_]+|vm/(boot|prepare))$' || true
}

# Records that everything in HEAD has been checked, unless there are uncommitted changes.
#   record_all RECORD
record_all() {
    if [ -z "$(git status --porcelain -- . ":!$1")" ]; then
        git rev-parse HEAD >"$1"
    fi
}
