#pragma once

#include <span>
#include <utility>
#include <vector>

#include "model/board/document.h"

namespace model {

/// From elements to the pins and components they belong to, and back. A pad or plated hole belongs to the pin that its
/// subnet names, and to none if the job says that it is of a via, track or plane: vias lie in the exposed pads of many
/// packages. Where the job says nothing, it belongs to the pins of its net (of none, if it has none) that lie within
/// its box, but a pad on the far side of the board to no pin of a surface-mount component. Pins that have no element by
/// that, as those of a second part on the same pads, share those of their net that they lie in. A body belongs to its
/// component. Made once for a document, which must outlive it, with its index (BoardIndex::pins): 20 bytes a pin, and
/// one look at every pad and hole.
class PinFinder {
public:
    explicit PinFinder(const Document& document);
    /// The same for a document that differs in heights only.
    PinFinder(PinFinder same, const Document& document) : PinFinder(std::move(same)) { m_document = &document; }

    /// Rising; empty for what is neither pad nor hole.
    [[nodiscard]] std::vector<PinId> pinsOf(ElementId element) const;
    /// None if it belongs to none.
    [[nodiscard]] ComponentId componentOf(ElementId element) const;
    /// Pads and holes, rising.
    [[nodiscard]] std::vector<ElementId> elementsOf(PinId pin) const;
    /// In no particular order.
    [[nodiscard]] std::span<const PinId> pinsOf(NetId net) const;
    /// Pads, holes and the body, rising.
    [[nodiscard]] std::vector<ElementId> elementsOf(ComponentId component) const;

private:
    [[nodiscard]] std::size_t groupOf(NetId net) const;
    [[nodiscard]] bool mayHavePins(ElementId element) const;
    /// May it be of the pins that lie in it? Not if the job says what else it is.
    [[nodiscard]] bool mayBeByLocation(ElementId element) const;
    [[nodiscard]] bool mayBeOn(PinId pin, const Layer& layer) const;
    void groupPins();
    void listElements();
    [[nodiscard]] std::vector<ElementId> sharedBy(const Pin& pin) const;

    const Document* m_document;
    std::vector<std::uint32_t> m_start;  ///< pins of net n: m_pins[m_start[n] .. m_start[n + 1]), those of none last
    std::vector<PinId> m_pins;           ///< of a net from left to right
    std::vector<std::uint32_t> m_firstElement;  ///< of pin n: m_elements[m_firstElement[n] .. m_firstElement[n + 1])
    std::vector<ElementId> m_elements;
};

}  // namespace model
