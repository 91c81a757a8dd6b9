#include "model/formats/kicad/footprints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "model/board/pad_group_names.h"
#include "model/formats/kicad/barcodes.h"
#include "model/formats/kicad/dimensions.h"
#include "model/formats/kicad/pads.h"
#include "model/formats/kicad/shapes/largest_outline.h"
#include "model/formats/kicad/text/values.h"
#include "model/formats/kicad/text_boxes.h"
#include "model/formats/kicad/texts.h"
#include "model/formats/kicad/zones.h"
#include "model/geometry/outlines.h"

namespace model::kicad {

namespace {

using formats::DrawnComponent;
using formats::DrawnPackage;
using formats::kNoRow;

constexpr double kJoint = 10'000.0;
constexpr std::array<std::string_view, 6> kMarks = {
    "exclude_from_bom", "exclude_from_pos_files", "board_only", "allow_missing_courtyard", "dnp", "virtual"};

/// Lists of a footprint that draw nothing: what readFacts and the frame take, rules, and what editors need.
constexpr std::array<std::string_view, 40> kSilent = {"at",
                                                      "attr",
                                                      "autoplace_cost180",
                                                      "autoplace_cost90",
                                                      "clearance",
                                                      "component_classes",
                                                      "constraint",
                                                      "descr",
                                                      "duplicate_pad_numbers_are_jumpers",
                                                      "embedded_files",
                                                      "embedded_fonts",
                                                      "generator",
                                                      "generator_version",
                                                      "group",
                                                      "jumper_pad_groups",
                                                      "layer",
                                                      "locked",
                                                      "model",
                                                      "net_tie_pad_groups",
                                                      "path",
                                                      "placed",
                                                      "point",
                                                      "private_layers",
                                                      "sheetfile",
                                                      "sheetname",
                                                      "solder_mask_margin",
                                                      "solder_paste_margin",
                                                      "solder_paste_margin_ratio",
                                                      "solder_paste_ratio",
                                                      "stackup",
                                                      "tags",
                                                      "tedit",
                                                      "thermal_gap",
                                                      "thermal_width",
                                                      "transform",
                                                      "tstamp",
                                                      "units",
                                                      "uuid",
                                                      "version",
                                                      "zone_connect"};

/// (at x y degrees), or what takes its place after KiCad 10: (transform (translate x y) (rotate degrees) (scale 1 1)).
Frame frameOf(Canvas& canvas, const Item& footprint) {
    const Item at = footprint.find("at");
    const Item transform = footprint.find("transform");
    if (at.isThere() || !transform.isThere()) {
        return {point(footprint, "at").value_or(PointD()), numberOf(at.word(3)).value_or(0.0)};
    }
    const Item scale = transform.find("scale");
    if (numberOf(scale.word(1)).value_or(1.0) != 1.0 || numberOf(scale.word(2)).value_or(1.0) != 1.0) {
        canvas.report(Severity::Warning, footprint.line(), "a footprint is scaled, which is not read");
    }
    return {point(transform, "translate").value_or(PointD()), number(transform, "rotate", 0.0)};
}

/// The largest outline of drawn shapes; the box around them all where none is closed.
ShapeSketch bodyOf(const std::vector<Graphic>& graphics) {
    std::vector<ChainEdge> edges;
    Box around;
    for (const Graphic& graphic : graphics) {
        addEdges(graphic, edges);
        for (const PathNode& node : graphic.nodes) {
            around.include(node.point);
        }
    }
    ShapeSketch body = largestOutline(edges, kJoint);
    if (body.isEmpty() && around.width() > 0 && around.height() > 0) {
        addBox(body, around);
    }
    return body;
}

void append(std::string& key, std::int64_t value) {
    key.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append(std::string& key, const ShapeSketch& sketch) {
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        append(key, sketch.isHole(i) ? -1 : -2);
        for (const PathNode& node : sketch.contour(i)) {
            for (const std::int64_t value : {std::int64_t{node.point.x}, std::int64_t{node.point.y},
                                             std::int64_t{node.centre.x}, std::int64_t{node.centre.y}}) {
                append(key, value);
            }
            append(key, static_cast<std::int64_t>(node.edge));
        }
    }
}

std::string keyOf(const DrawnPackage& package) {
    std::string key = package.name + '\n';
    append(key, package.outline);
    for (const formats::DrawnPackagePin& pin : package.pins) {
        key += pin.name + '\n';
        append(key, pin.position.x);
        append(key, pin.position.y);
        append(key, static_cast<std::int64_t>(pin.kind));
        append(key, pin.outline);
    }
    return key;
}

bool isField(const Item& text) {
    return text.head() == "property" || text.word(1) != "user";
}

/// Up to KiCad 5 texts have %R for the reference and %V for the value; later versions still read them so.
std::string withNewMarks(std::string text) {
    for (const auto& [old, name] : {std::pair("%R", "${REFERENCE}"), std::pair("%V", "${VALUE}")}) {
        for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at)) {
            text.replace(at, 2, name);
        }
    }
    return text;
}

/// One footprint.
class FootprintMaker {
public:
    FootprintMaker(Canvas& canvas, UnusedPads& unused, std::vector<ChainEdge>& outline, const Item& footprint)
        : m_canvas(canvas), m_unused(unused), m_outline(outline), m_item(footprint) {
        m_owner.frame = frameOf(canvas, footprint);
        m_owner.isOnBack = canvas.layers().nameOf(canvas.layers().row(footprint.find("layer").word(1))) == "B.Cu";
        m_owner.maskMargin = lengthOf(footprint.find("solder_mask_margin").word(1));
        m_owner.pasteMargin = lengthOf(footprint.find("solder_paste_margin").word(1));
        m_owner.pasteRatio = numberOf(footprint.find("solder_paste_margin_ratio").word(1));
        if (!m_owner.pasteRatio) {
            m_owner.pasteRatio = numberOf(footprint.find("solder_paste_ratio").word(1));
        }
    }

    /// Is there room for it?
    bool begin() {
        const std::optional<Point> at = m_canvas.onGrid(m_owner.frame.origin, m_item.line());
        if (!at) {
            return false;
        }
        const std::string name = m_item.text(1);
        const std::size_t colon = name.find(':');
        DrawnPackage package;
        package.name = colon == std::string::npos ? name : name.substr(colon + 1);
        DrawnComponent component;
        component.position = *at;
        component.package = static_cast<std::int32_t>(m_canvas.step().packages.size());
        component.side = m_owner.isOnBack ? LayerSide::Bottom : LayerSide::Top;
        component.isMirrored = m_owner.isOnBack;
        // What is on the back was turned over its horizontal axis: mirrored x to -x, and half a turn.
        component.clockwiseDeg =
            std::fmod((m_owner.isOnBack ? m_owner.frame.degrees + 180.0 : -m_owner.frame.degrees) + 720.0, 360.0);
        component.line = m_item.line();
        m_owner.component = static_cast<std::int32_t>(m_canvas.step().components.size());
        m_canvas.step().packages.push_back(std::move(package));
        m_canvas.step().components.push_back(std::move(component));
        return true;
    }

    void draw() {
        readFacts();
        for (const Item item : m_item) {
            const std::string_view head = item.head();
            if (head == "pad") {
                drawPad(m_canvas, m_unused, item, m_owner);
            } else if (isGraphic(head)) {
                addGraphic(item);
            } else if (head == "fp_text" || head == "property") {
                addText(item);
            } else if (head == "fp_text_box" || head == "table") {
                addTextBox(item);
            } else if (head == "barcode") {
                addBarcode(item);
            } else if (head == "image") {
                m_canvas.report(Severity::Info, item.line(), "images are for the eyes of editors; they are not drawn");
            } else if (head == "zone") {
                drawZone(m_canvas, item);
            } else if (head == "dimension") {
                drawDimension(m_canvas, item, [&](std::string_view name) { return variable(name); });
            } else if (head == "variant") {
                m_canvas.reportVariants(item);
            } else if (item.isList() && std::ranges::find(kSilent, head) == kSilent.end()) {
                m_canvas.reportNotDrawn(item);
            }
        }
        package().outline.append(bodyOf(m_fab.empty() ? m_courtyard : m_fab),
                                 {{}, m_owner.isOnBack ? 180.0 : 0.0, m_owner.isOnBack});
    }

private:
    [[nodiscard]] DrawnComponent& component() {
        return m_canvas.step().components[static_cast<std::size_t>(m_owner.component)];
    }
    [[nodiscard]] DrawnPackage& package() {
        return m_canvas.step().packages[static_cast<std::size_t>(component().package)];
    }

    void readFacts() {
        const Item attr = m_item.find("attr");
        component().mount = attr.hasWord("smd")            ? MountType::Surface
                            : attr.hasWord("through_hole") ? MountType::ThroughHole
                                                           : MountType::Unknown;
        component().isPopulated = !attr.hasWord("dnp");
        for (const Item item : m_item) {
            if (item.head() == "property") {
                readProperty(item.text(1), item.text(2));
            } else if (item.head() == "fp_text" && item.word(1) != "user") {
                readProperty(item.word(1) == "reference" ? "Reference" : "Value", item.text(2));
            }
        }
        for (const std::string_view mark : kMarks) {
            if (attr.hasWord(mark)) {
                component().properties.emplace_back(mark, "yes");
            }
        }
        readPadGroups();
        for (const char* head : {"descr", "tags", "sheetname", "sheetfile", "uuid", "tstamp"}) {
            const std::string value = m_item.find(head).text(1);
            if (!value.empty()) {
                component().properties.emplace_back(std::string(head) == "tstamp" ? "uuid" : head, value);
            }
        }
    }

    /// As model/nets/pad_groups.h says.
    void readPadGroups() {
        for (const std::string& group : tieGroups()) {
            component().properties.emplace_back(kNetTieGroup, group);
        }
        for (const Item group : m_item.find(kJumperGroup)) {
            if (group.isList()) {
                component().properties.emplace_back(kJumperGroup, listOf(group));
            }
        }
        if (m_item.isSet(kDuplicatesAreJumpers)) {
            component().properties.emplace_back(kDuplicatesAreJumpers, "yes");
        }
    }

    /// Up to KiCad 6 the keywords made a footprint a net tie of all its pads.
    [[nodiscard]] std::vector<std::string> tieGroups() const {
        constexpr int kFirstWithGroups = 20'220'818;
        std::vector<std::string> groups;
        const Item declared = m_item.find(kNetTieGroup);
        for (const Item group : declared) {
            if (group.isQuoted()) {
                groups.push_back(unescaped(group.source()));
            }
        }
        if (m_canvas.settings().version < kFirstWithGroups && m_item.find("tags").text(1).starts_with("net tie")) {
            std::string all;
            for (const Item item : m_item) {
                if (item.head() == "pad" && !item.word(1).empty()) {
                    all += (all.empty() ? "" : ", ") + item.text(1);
                }
            }
            groups.push_back(all);
        }
        return groups;
    }

    /// ("1" "2") as "1, 2".
    static std::string listOf(const Item& list) {
        std::string text;
        for (const Item word : list) {
            text += (text.empty() ? "" : ", ") + unescaped(word.source());
        }
        return text;
    }

    void readProperty(const std::string& name, const std::string& value) {
        if (name == "Reference") {
            component().refdes = value;
            return;
        }
        if (name == "Value") {
            component().part = value;  // no field is for the name or number of a part
        }
        if (!value.empty() && !name.starts_with("ki_")) {
            component().properties.emplace_back(name, value);
        }
    }

    void addGraphic(const Item& item) {
        const std::int32_t row = m_canvas.layers().row(item.find("layer").word(1));
        const std::string& layer = m_canvas.layers().nameOf(row);
        const bool isFab = layer.ends_with(".Fab");
        const bool isCourtyard = layer.ends_with(".CrtYd");
        Origin origin;
        origin.line = item.line();
        origin.net = m_canvas.netOf(item);
        origin.component = m_owner.component;
        drawGraphic(m_canvas, item, m_owner.frame, origin);
        if (!isFab && !isCourtyard && layer != "Edge.Cuts") {
            return;
        }
        const std::optional<Graphic> graphic =
            graphicOf(m_canvas, item, layer == "Edge.Cuts" ? m_owner.frame : Frame());
        if (graphic && layer == "Edge.Cuts") {
            addEdges(*graphic, m_outline);
        } else if (graphic) {
            (isFab ? m_fab : m_courtyard).push_back(*graphic);
        }
    }

    void addText(const Item& item) {
        const std::optional<PointD> at = point(item, "at");
        const bool isFact = item.head() == "property" && !(at && item.find("layer").isThere());
        if (isFact || isHidden(item)) {
            return;
        }
        if (!at) {
            m_canvas.report(Severity::Warning, item.line(), "a text has no place; it was left out");
            return;
        }
        const double degrees = numberOf(item.find("at").word(3)).value_or(0.0);
        Origin origin;
        origin.line = item.line();
        origin.component = m_owner.component;
        const Variables variables = [&](std::string_view name) { return variable(name); };
        const std::string text = isField(item) ? item.text(2) : withNewMarks(item.text(2));
        TextPlace place{item, shownText(m_canvas, item, text, variables), {m_owner.frame.apply(*at), degrees}, true};
        place.isUpright = !item.isSet("unlocked") && !item.find("at").hasWord("unlocked");
        drawText(m_canvas, place, origin);
    }

    void addTextBox(const Item& item) {
        Origin origin;
        origin.line = item.line();
        origin.component = m_owner.component;
        const Variables variables = [&](std::string_view name) { return variable(name); };
        if (item.head() == "table") {
            drawTable(m_canvas, item, m_owner.frame, variables, origin);
        } else {
            drawTextBox(m_canvas, item, m_owner.frame, variables, origin);
        }
    }

    void addBarcode(const Item& item) {
        Origin origin;
        origin.line = item.line();
        origin.component = m_owner.component;
        drawBarcode(
            m_canvas, item, [&](std::string_view name) { return variable(name); }, origin);
    }

    std::optional<std::string> variable(std::string_view name) {
        if (name == "REFERENCE") {
            return component().refdes;
        }
        if (name == "VALUE") {
            return component().part;
        }
        if (name == "FOOTPRINT_NAME") {
            return package().name;
        }
        if (name == "FOOTPRINT_LIBRARY") {
            const std::string footprint = m_item.text(1);  // library:name
            const std::size_t colon = footprint.find(':');
            return colon == std::string::npos ? std::string() : footprint.substr(0, colon);
        }
        for (const auto& [property, value] : component().properties) {
            if (property == name) {
                return value;
            }
        }
        const auto& variables = m_canvas.settings().variables;
        const auto found = variables.find(name);
        return found == variables.end() ? std::nullopt : std::optional(found->second);
    }

    Canvas& m_canvas;
    UnusedPads& m_unused;
    std::vector<ChainEdge>& m_outline;
    const Item& m_item;
    PadOwner m_owner;
    std::vector<Graphic> m_fab;
    std::vector<Graphic> m_courtyard;
};

}  // namespace

void addEdges(const Graphic& graphic, std::vector<ChainEdge>& edges) {
    for (std::size_t i = 0; i < graphic.edgeCount(); ++i) {
        edges.push_back({graphic.nodes[i], graphic.endOf(i)});
    }
}

void Footprints::draw(const Item& footprint) {
    FootprintMaker maker(m_canvas, m_unused, m_outline, footprint);
    if (!maker.begin()) {
        return;
    }
    maker.draw();
    std::vector<DrawnPackage>& packages = m_canvas.step().packages;
    const auto row = static_cast<std::int32_t>(packages.size()) - 1;
    const auto [found, isNew] = m_packages.try_emplace(keyOf(packages.back()), row);
    if (!isNew) {
        packages.pop_back();
        m_canvas.step().components.back().package = found->second;
    }
    reportFlipped();
    reportSharedName();
}

/// The first one says it for all.
void Footprints::reportFlipped() {
    const DrawnComponent& last = m_canvas.step().components.back();
    if (last.side == LayerSide::Bottom && !std::exchange(m_hasFlipped, true)) {
        m_canvas.report(Severity::Info, last.line,
                        "footprints on the back are stored as seen through the board; they were flipped, and their "
                        "parts' rotations with them: 180° more than KiCad says, clockwise as seen from below");
    }
}

/// Drawings that are footprints, and parts that nobody has numbered yet, share their names as a rule.
void Footprints::reportSharedName() {
    const DrawnComponent& last = m_canvas.step().components.back();
    const bool isNumbered = !last.refdes.empty() && !last.refdes.ends_with('*') && !last.refdes.ends_with('?');
    if (isNumbered && !last.pins.empty() && !m_designators.insert(last.refdes).second) {
        m_canvas.report(Severity::Warning, last.line, "two components have one designator; its name stands for both");
    }
}

}  // namespace model::kicad
