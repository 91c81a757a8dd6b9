#pragma once

#include <string>
#include <utility>
#include <vector>

#include "model/clearance/rule_report.h"
#include "model/index/pin_finder.h"

namespace model {

/// What lies on one side of a location, in words.
struct Side {
    std::string net;  ///< its name, "(no net)", or without an element "(board edge)", "(no pad)"
    std::string pin;  ///< "U5.3"; of several that share a pad the first; empty if it belongs to none
    std::string
        kind;  ///< "pad", "track", "area", "via", "microvia", "component hole", "NPTH", …; empty without element
    ElementId element;
};
/// "GND, U5.3, pad, element 1234"
[[nodiscard]] std::string textOf(const Side& side);

/// Tells sides of findings and clearances of one document apart, also where there is no net. Made once (a look at every
/// pad and hole); the document must outlive it.
class SideNames {
public:
    explicit SideNames(const Document& document);

    [[nodiscard]] Side of(ElementId element) const;
    [[nodiscard]] std::pair<Side, Side> of(const RuleFinding& finding) const;

private:
    [[nodiscard]] std::string kindOf(ElementId element) const;

    const Document& m_document;
    PinFinder m_pins;
    std::vector<bool> m_isMicrovia;  ///< by element
};

}  // namespace model
