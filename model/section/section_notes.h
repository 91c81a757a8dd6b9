#pragma once

#include <set>
#include <utility>

#include "model/board/copies.h"
#include "model/section/section.h"

/// What must be known to read a section, in plain words.
namespace model {

/// What was met while cutting that the pieces alone do not tell.
struct CutFindings {
    std::set<std::pair<std::uint32_t, ElementId>> wallless;  ///< copy and area: plated, with walls that are not known
    std::size_t landed = 0;                                  ///< laser vias met
    std::set<LayerId> undrawn;                               ///< films that are where their zones are
    std::set<BoardElement> milled;                           ///< of which something is left out
};

/// Adds what is left out or drawn without what the job does not say.
void addNotes(const Document& board, const CutFindings& findings, Section& section);
/// Adds, as one note, what the section shows that the job does not say.
void addAssumptions(const Document& board, const CutFindings& findings, Section& section);

}  // namespace model
