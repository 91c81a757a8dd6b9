#include "model/agreement/part_agreement.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/geometry/vectors.h"
#include "model/text/formatting.h"

namespace model {

namespace {

using Part = FlatBoard::Part;
using PinAt = FlatBoard::PinAt;

constexpr double kSameAngle = 0.01;

double angleBetween(double a, double b) {
    const double apart = std::abs(a - b);
    return std::min(apart, 360.0 - apart);
}

std::string mm(double nm) {
    return fixedText(base::toMm(nm), 4) + " mm";
}

const char* sideOf(const Part& part) {
    return part.isBottom ? "bottom" : "top";
}

class PartComparer {
public:
    PartComparer(const FlatBoard& a, const FlatBoard& b, Nm reach, const AgreementRequest& request)
        : m_a(a), m_b(b), m_reach(reach), m_most(request.most), m_isTaken(b.parts.size()) {
        for (std::size_t row = 0; row < b.parts.size(); ++row) {
            m_named[b.parts[row].refdes].push_back(row);
        }
    }

    MatchedParts run() {
        m_found.parts.aspect = Aspect::Parts;
        m_found.parts.counts = {m_a.parts.size(), m_b.parts.size()};
        m_found.pins.aspect = Aspect::Pins;
        m_found.pins.counts = {m_a.pins.size(), m_b.pins.size()};
        if (m_a.parts.empty() || m_b.parts.empty()) {
            m_found.parts.accord = m_found.pins.accord = Accord::NotCompared;
            m_found.parts.note = m_found.pins.note = std::string(m_a.parts.empty() ? "A" : "B") + " has no parts";
            return std::move(m_found);
        }
        for (const Part& part : m_a.parts) {
            compare(part);
        }
        for (std::size_t row = 0; row < m_b.parts.size(); ++row) {
            if (m_isTaken[row] == 0) {
                addMissing("B", m_b.parts[row]);
            }
        }
        noteParts();
        return std::move(m_found);
    }

private:
    void add(Comparison& comparison, const std::string& text, Point at) { comparison.add({text, at}, m_most); }

    void addMissing(const char* board, const Part& part) {
        if (part.pinCount == 0) {
            ++m_withoutPins;
        } else {
            add(m_found.parts, std::string("only ") + board + " has " + std::string(part.refdes), part.position);
        }
    }

    void noteParts() {
        std::vector<std::string> notes;
        if (m_withoutPins > 0) {
            notes.push_back(std::to_string(m_withoutPins) +
                            (m_withoutPins == 1 ? " part without pins is" : " parts without pins are") +
                            " in one job only");
        }
        if (m_otherwiseTurned > 0) {
            notes.push_back(std::to_string(m_otherwiseTurned) +
                            (m_otherwiseTurned == 1
                                 ? " part states another rotation, but all its pins lie at the same locations"
                                 : " parts state another rotation, but all their pins lie at the same locations"));
        }
        if (m_unplaced > 0) {
            notes.push_back("where " + std::to_string(m_unplaced) +
                            (m_unplaced == 1
                                 ? " part lies is not said by both jobs: its side and pins are compared"
                                 : " parts lie is not said by both jobs: their sides and pins are compared"));
        }
        if (m_withoutSide > 0) {
            notes.push_back(
                "the side of " + std::to_string(m_withoutSide) + (m_withoutSide == 1 ? " part" : " parts") +
                " with pins through the board, or without any, is not said by both jobs: it is not compared");
        }
        m_found.parts.note = joined(notes, "; ");
        if (m_nameless > 0) {
            m_found.pins.note =
                std::to_string(m_nameless) +
                (m_nameless == 1 ? " pad without a number, which only one job takes for a pin, is not compared"
                                 : " pads without a number, which only one job takes for pins, are not compared");
        }
    }

    /// The nearest of that name that is free.
    const Part* partnerOf(const Part& part) {
        const auto named = m_named.find(part.refdes);
        if (named == m_named.end()) {
            return nullptr;
        }
        const auto far = [&](std::size_t row) {
            return m_isTaken[row] != 0 ? HUGE_VAL : distance(part.position, m_b.parts[row].position);
        };
        const std::size_t best = *std::ranges::min_element(named->second, {}, far);
        if (m_isTaken[best] != 0) {
            return nullptr;
        }
        m_isTaken[best] = 1;
        return &m_b.parts[best];
    }

    void compare(const Part& part) {
        const Part* other = partnerOf(part);
        if (other == nullptr) {
            return addMissing("A", part);
        }
        const std::string name(part.refdes);
        const bool arePlaced = part.isPlaced && other->isPlaced;
        m_unplaced += arePlaced ? 0 : 1;
        if (arePlaced) {
            m_found.parts.measure(part.position, other->position);
        }
        const bool haveSides = part.hasSide && other->hasSide;
        m_withoutSide += haveSides ? 0 : 1;
        if (haveSides && part.isBottom != other->isBottom) {
            add(m_found.parts, name + " is on the " + sideOf(part) + " in A, on the " + sideOf(*other) + " in B",
                part.position);
        } else if (arePlaced && !isSamePlace(part.position, other->position, m_reach)) {
            add(m_found.parts, name + " is moved by " + mm(distance(part.position, other->position)), part.position);
        }
        const bool arePinsEqual = comparePins(part, *other);
        if (arePlaced && part.isBottom == other->isBottom &&
            angleBetween(part.clockwiseDeg, other->clockwiseDeg) > kSameAngle) {
            compareRotation(part, *other, arePinsEqual);
        }
    }

    /// Where the pins lie says how a part is turned; the number alone also depends on how its package is drawn.
    void compareRotation(const Part& part, const Part& other, bool arePinsEqual) {
        if (arePinsEqual && part.pinCount > 0) {
            ++m_otherwiseTurned;
            return;
        }
        add(m_found.parts,
            std::string(part.refdes) + " is turned by " + fixedText(part.clockwiseDeg, 2) + " degrees in A, by " +
                fixedText(other.clockwiseDeg, 2) + " in B",
            part.position);
    }

    // ---- pins ----

    /// How unlike two pins are; they are matched with the least unlike first.
    [[nodiscard]] int unlike(const PinAt& a, const PinAt& b) const {
        return (isSamePlace(a.position, b.position, m_reach) ? 0 : 1) + (a.name == b.name ? 0 : 2);
    }

    /// Do they all lie at the same locations?
    bool comparePins(const Part& part, const Part& other) {
        const std::size_t before = m_found.pins.differing;
        std::vector<std::uint32_t> ours;
        std::vector<std::uint32_t> theirs;
        for (std::uint32_t i = 0; i < part.pinCount; ++i) {
            ours.push_back(part.firstPin + i);
        }
        for (std::uint32_t i = 0; i < other.pinCount; ++i) {
            theirs.push_back(other.firstPin + i);
        }
        // The same name and place; the same name; the same place.
        for (const int most : {0, 1, 2}) {
            matchPins(part, most, ours, theirs);
        }
        for (const std::uint32_t pin : ours) {
            addMissing("A", part, m_a.pins[pin]);
        }
        for (const std::uint32_t pin : theirs) {
            addMissing("B", part, m_b.pins[pin]);
        }
        return m_found.pins.differing == before;
    }

    /// Pads without a number are pins of a part in some formats, and plain copper in others.
    void addMissing(const char* board, const Part& part, const PinAt& pin) {
        if (pin.name.empty()) {
            ++m_nameless;
        } else {
            add(m_found.pins, std::string("only ") + board + " has " + pinName(part, pin), pin.position);
        }
    }

    void matchPins(const Part& part, int most, std::vector<std::uint32_t>& ours, std::vector<std::uint32_t>& theirs) {
        std::erase_if(ours, [&](std::uint32_t pin) {
            const auto found = std::ranges::find_if(
                theirs, [&](std::uint32_t other) { return unlike(m_a.pins[pin], m_b.pins[other]) == most; });
            if (found == theirs.end()) {
                return false;
            }
            reportPin(part, m_a.pins[pin], m_b.pins[*found]);
            m_found.samePins.emplace_back(pin, *found);
            theirs.erase(found);
            return true;
        });
    }

    void reportPin(const Part& part, const PinAt& a, const PinAt& b) {
        m_found.pins.measure(a.position, b.position);
        const bool areNamed = !a.name.empty() && !b.name.empty();  // some formats name pads that others leave nameless
        if (areNamed && a.name != b.name) {
            add(m_found.pins, pinName(part, a) + " is called " + std::string(b.name) + " in B", a.position);
        } else if (!isSamePlace(a.position, b.position, m_reach)) {
            add(m_found.pins, pinName(part, a) + " is moved by " + mm(distance(a.position, b.position)), a.position);
        }
    }

    static std::string pinName(const Part& part, const PinAt& pin) {
        return std::string(part.refdes) + "." + std::string(pin.name);
    }

    const FlatBoard& m_a;
    const FlatBoard& m_b;
    Nm m_reach;
    std::size_t m_most;
    std::map<std::string_view, std::vector<std::size_t>> m_named;  ///< parts of B
    std::vector<std::uint8_t> m_isTaken;
    std::size_t m_withoutPins = 0;
    std::size_t m_otherwiseTurned = 0;
    std::size_t m_unplaced = 0;
    std::size_t m_withoutSide = 0;
    std::size_t m_nameless = 0;  ///< pins
    MatchedParts m_found;
};

}  // namespace

MatchedParts compareParts(const FlatBoard& a, const FlatBoard& b, Nm reach, const AgreementRequest& request) {
    return PartComparer(a, b, reach, request).run();
}

}  // namespace model
