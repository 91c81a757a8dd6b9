#pragma once

#include "model/session/session_json.h"

/// One part of a session that two programs changed at once: both began with `base`; one now has `mine` and is about to
/// write it, the other one has written `theirs`. Nothing that one of them added or changed is lost, but for what both
/// changed, where mine counts; what one removed is gone. Null is a part, or an entry, that is not there.
namespace model::session {

/// What of a part is taken from one of the two as it is.
enum class Unit {
    Whole,  ///< all of it: pieces of two tables of rules are no table of rules
    Name,   ///< the entry of a name: a key of an object, or "name" and "step" of what a list holds
    /// What a list holds, known by all that it says: two views of one name are two views, and so are two versions of
    /// one view that both changed.
    Item
};

struct Merged {
    Json part;
    bool hasTheirs = false;       ///< something that mine does not have, or has otherwise
    bool replacesTheirs = false;  ///< lacks something that they changed, because mine changed it too
};

/// What is of mine lies as there; what only theirs has follows. A part that is no object and no list is merged whole.
[[nodiscard]] Merged merge(Unit unit, const Json& base, const Json& mine, const Json& theirs);

}  // namespace model::session
