#!/usr/bin/env bash
# catches_violations.sh SCRATCH
# Plants one fault after the other in a small tree that is in order: check_documents.sh must name each, else it proves nothing.
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
readonly here scratch=$1
failures=0

make_tree() {
    rm -rf "$scratch"
    mkdir -p "$scratch/docs/decisions" "$scratch/model"
    cd "$scratch" || exit 2
    printf '# Here\n[notes](docs/odb-notes.md#units) [out](https://example.org/docs/x.md) `model/a.h`\n' >README.md
    printf '## Stack, drills, components\nSee decision 2 and [it](decisions/0002-b.md).\n' >docs/odb-notes.md
    printf '// docs/odb-notes.md (odb-notes, Drills), decision 0002\n' >model/a.h
    printf '# 1. A\n\nStatus: superseded by 0002\n' >docs/decisions/0001-a.md
    printf '# 2. B\n\nStatus: in force\n\nReplaces record 1 (0001); 0.0003 is no record.\n' >docs/decisions/0002-b.md
    printf '| [0001](0001-a.md) | A | superseded by 0002 |\n| [0002](0002-b.md) | B | in force |\n' >docs/decisions/README.md
}

# must_name PART COMMAND...: after COMMAND has planted its fault, the check fails and says PART.
must_name() {
    local part=$1 said
    shift
    make_tree
    "$@"
    if said=$(bash "$here/check_documents.sh" "$scratch" 2>&1) || [[ $said != *"$part"* ]]; then
        echo "not caught: $*: $said" >&2
        failures=$((failures + 1))
    fi
}

append() {
    printf '%s\n' "$2" >>"$1"
}

make_tree
bash "$here/check_documents.sh" "$scratch" || { echo "wrongly refused" >&2; failures=1; }
must_name 'README.md:3: the link leads nowhere: gone.md' append README.md '[gone](gone.md#part)'
must_name 'docs/odb-notes.md:3: the link leads nowhere: ../gone.h' append docs/odb-notes.md '[gone](../gone.h)'
must_name 'model/a.h:2: there is no docs/gone.md' append model/a.h '// See docs/gone.md.'
must_name 'README.md:3: there is no docs/gone' append README.md 'in `docs/gone`'
must_name 'no such section: odb-notes, Gone' append model/a.h '/// (odb-notes, Gone)'
must_name 'README.md:3: there is no model/gone.cpp' append README.md '`model/gone.cpp`'
must_name 'README.md:3: there is no test gone_test' append README.md '`gone_test`'
must_name 'no such decision: decision 3' append model/a.h '// decision 3'
must_name 'no such decision: record 70' append docs/decisions/0002-b.md 'see record 70'
must_name 'no such decision: (0070' append docs/decisions/0002-b.md '(0070)'
must_name '0002-b.md: no line "Status' sed -i '/^Status/d' docs/decisions/0002-b.md
must_name '0002-b.md: no line "Status' sed -i 's/in force/proposed/' docs/decisions/0002-b.md
must_name 'a decision that does not exist: 0009' sed -i 's/in force/amended by 0009/' docs/decisions/0002-b.md
must_name 'its first line is not "# 2. Title"' sed -i '1s/2/7/' docs/decisions/0002-b.md
must_name 'there is no row: | [0001](0001-a.md) | A2 |' sed -i '1s/A/A2/' docs/decisions/0001-a.md
must_name 'there is no row: | [0002](0002-b.md) | B | in force |' sed -i '/0002-b/d' docs/decisions/README.md
must_name 'there are no decisions' rm -r docs/decisions
rm -rf "$scratch"
[ "$failures" -eq 0 ]
