#!/usr/bin/env bash
# check_documents.sh ROOT
# Names every link, cited document, cited decision and named source file or test that is not there, and every decision without a status or without
# its row in the index. Fails if there is any.
set -u
cd "$1" || exit 2
readonly decisions=docs/decisions
failures=0

violation() {
    echo "$*" >&2
    failures=$((failures + 1))
}

# find_texts NAME...: files of these names that people write; build trees, hidden folders and this test's planted faults are not looked at.
find_texts() {
    local name wanted=()
    for name in "$@"; do
        wanted+=(-o -name "$name")
    done
    find . \( -name '.?*' -o -path './build*' -o -path ./out -o -path ./tests/documents -o -path ./tests/architecture -o -path ./tests/data \) -prune \
        -o -type f \( "${wanted[@]:1}" \) -print | sed 's|^\./||' | sort
}

# cited PATTERN FILE...: a line "file:line:match" for each match.
cited() {
    local pattern=$1
    shift
    [ $# -eq 0 ] || grep -HnoE "$pattern" -- "$@"
}

has_decision() {
    local number
    printf -v number %04d "$((10#$1))"
    compgen -G "$decisions/$number-*.md" >/dev/null
}

check_links() {
    local file line text target folder
    while IFS=: read -r file line text; do
        target=${text#'('}
        target=${target%%[#)]*}
        folder=.
        [ "$file" = "${file##*/}" ] || folder=${file%/*}
        [ -z "$target" ] || [ -e "$folder/$target" ] || violation "$file:$line: the link leads nowhere: $target"
    done < <(cited '\]\([^):]+\)' "${documents[@]}" | sed 's/:\](/:(/')
}

check_documents_cited() {
    local file line text
    while IFS=: read -r file line text; do
        text=docs/${text#*docs/}
        [ -e "$text" ] || violation "$file:$line: there is no $text"
    done < <(cited '(^|[^A-Za-z0-9_/.-])docs/[A-Za-z0-9_/-]+(\.[a-z]+)?' "${all[@]}")
    while IFS=: read -r file line text; do
        grep -qi "^## .*${text#*, }" docs/odb-notes.md || violation "$file:$line: docs/odb-notes.md has no such section: $text"
    done < <(cited 'odb-notes, [A-Z][a-z]+' "${all[@]}")
}

check_sources_named() {
    local file line text
    while IFS=: read -r file line text; do
        text=${text//\`/}
        [ -e "$text" ] || violation "$file:$line: there is no $text"
    done < <(cited '`(app|model|render|scripts|shaders|tests|tri|ui)/[A-Za-z0-9_./-]+\.(h|cpp|glsl|cmake|sh|txt)`' "${guides[@]}")
}

# Some tests have the name of their area before that of their file, some are only named where they are registered.
has_test() {
    [ -n "$(find tests -name "$1.cpp" -o -path "*/${1%%_*}/*" -name "${1#*_}.cpp" 2>/dev/null)" ] ||
        grep -rqw --include='*.cmake' -- "$1" tests 2>/dev/null
}

check_tests_named() {
    local file line text
    while IFS=: read -r file line text; do
        has_test "${text//\`/}" || violation "$file:$line: there is no test ${text//\`/}"
    done < <(cited '`[a-z0-9_]+_test`' "${guides[@]}")
}

check_decisions_cited() {
    local file line text
    while IFS=: read -r file line text; do
        has_decision "${text//[^0-9]/}" || violation "$file:$line: there is no such decision: $text"
    done < <(
        cited '[Dd]ecisions? [0-9]{1,4}' "${all[@]}"
        cited '[Rr]ecord [0-9]{1,4}|[ (]0[0-9]{3}\b' "${records[@]}"
    )
}

# The form of a record: "# 7. Title" as its file is numbered, then its status, and both in the index.
check_record() {
    local file=$1 name=${1##*/} number title status='' line other
    number=${name:0:4}
    {
        IFS= read -r title
        while IFS= read -r line; do
            [ "$line" = "${line#Status: }" ] || status=${line#Status: }
        done
    } <"$file"
    title=${title#\# }
    [ "${title%%. *}" = "$((10#$number))" ] || violation "$file: its first line is not \"# $((10#$number)). Title\""
    [[ $status =~ ^(in force|(superseded|amended) by [0-9]{4}(, [0-9]{4})*)$ ]] ||
        violation "$file: no line \"Status: in force\", \"Status: superseded by NNNN\" or \"Status: amended by NNNN\""
    for other in ${status//[^0-9]/ }; do
        has_decision "$other" || violation "$file: its status names a decision that does not exist: $other"
    done
    local row="| [$number]($name) | ${title#*. } | $status |"
    [[ $index == *"$row"* ]] || violation "$decisions/README.md: there is no row: $row"
}

index=$(<$decisions/README.md)
mapfile -t all < <(find_texts '*.md' '*.h' '*.cpp' '*.glsl' '*.cmake' '*.txt' '*.sh' run test)
mapfile -t documents < <(find_texts '*.md')
mapfile -t records < <(compgen -G "$decisions/[0-9]*.md")
mapfile -t guides < <(compgen -G '*.md'; compgen -G 'docs/*.md')
[ ${#records[@]} -gt 0 ] || violation "there are no decisions below $1"
check_links
check_documents_cited
check_sources_named
check_tests_named
check_decisions_cited
for record in "${records[@]}"; do
    check_record "$record"
done
[ "$failures" -eq 0 ] || exit 1
echo "${#documents[@]} documents and ${#records[@]} decisions agree with what is there"
