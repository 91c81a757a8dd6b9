#include "model/geometry/box_index.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <utility>
#include <vector>

namespace model {

namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<base::Nm, 2, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using Entry = std::pair<TreeBox, std::uint32_t>;

TreeBox toTree(const base::Box& box) {
    return {{box.min.x, box.min.y}, {box.max.x, box.max.y}};
}

std::vector<Entry> entriesOf(std::span<const base::Box> boxes) {
    std::vector<Entry> entries;
    entries.reserve(boxes.size());
    for (std::size_t row = 0; row < boxes.size(); ++row) {
        if (!boxes[row].isEmpty()) {
            entries.emplace_back(toTree(boxes[row]), static_cast<std::uint32_t>(row));
        }
    }
    return entries;
}

}  // namespace

struct BoxIndex::Tree {
    explicit Tree(const std::vector<Entry>& entries) : tree(entries) {}
    bg::index::rtree<Entry, bg::index::rstar<16>> tree;
};

BoxIndex::BoxIndex(std::span<const base::Box> boxes) : m_tree(std::make_shared<const Tree>(entriesOf(boxes))) {}

void BoxIndex::visit(const base::Box& box, const std::function<void(std::uint32_t)>& visit) const {
    m_tree->tree.query(bg::index::intersects(toTree(box)),
                       boost::make_function_output_iterator([&](const Entry& entry) { visit(entry.second); }));
}

}  // namespace model
