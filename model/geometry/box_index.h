#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "model/base/point.h"

namespace model {

/// Finds boxes near a location: an R-tree, packed once. Rows are those of the span it was made from; empty boxes are
/// never found. Reading is safe from every thread; copies share the tree.
class BoxIndex {
public:
    explicit BoxIndex(std::span<const base::Box> boxes);

    /// Calls `visit(row)` for every box that shares a point with `box`, in an order that depends on the boxes only.
    void visit(const base::Box& box, const std::function<void(std::uint32_t)>& visit) const;

private:
    struct Tree;
    std::shared_ptr<const Tree> m_tree;
};

}  // namespace model
