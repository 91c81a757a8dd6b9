#include "model/formats/kicad/board_drawing.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/board/stackup.h"
#include "model/formats/common/outline_gaps.h"
#include "model/formats/kicad/barcodes.h"
#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/dimensions.h"
#include "model/formats/kicad/footprints.h"
#include "model/formats/kicad/graphics.h"
#include "model/formats/kicad/mask_webs.h"
#include "model/formats/kicad/shapes/chains.h"
#include "model/formats/kicad/text/tree.h"
#include "model/formats/kicad/text/values.h"
#include "model/formats/kicad/text_boxes.h"
#include "model/formats/kicad/texts.h"
#include "model/formats/kicad/tracks.h"
#include "model/formats/kicad/unused_pads.h"
#include "model/formats/kicad/vias.h"
#include "model/formats/kicad/zones.h"
#include "model/geometry/outlines.h"

namespace model::kicad {

namespace {

constexpr double kOutlineJoint = 10'000.0;  ///< ends of an outline that are joined
constexpr double kSameEnd = 1'000.0;        ///< further apart they are reported
constexpr int kNewestKnown = 20'260'206;    ///< that of KiCad 10
/// KiCad's own masks on boards without a stackup; its copper is as thick as ours.
constexpr Nm kMaskWithoutStackup = 10'000;
static_assert(kDefaultCopper == 35'000);

/// Items that draw nothing.
constexpr std::array<std::string_view, 15> kSilent = {"paper",          "page",
                                                      "host",           "links",
                                                      "group",          "generated",
                                                      "embedded_fonts", "embedded_files",
                                                      "generator",      "generator_version",
                                                      "version",        "component_classes",
                                                      "attr",           "point",
                                                      "constraint"};

std::string versionName(int version) {
    constexpr std::array<std::pair<int, const char*>, 8> kReleases = {{{20'250'000, "KiCad 10"},
                                                                       {20'240'200, "KiCad 9"},
                                                                       {20'221'100, "KiCad 8"},
                                                                       {20'211'100, "KiCad 7"},
                                                                       {20'190'000, "KiCad 6"},
                                                                       {20'160'000, "KiCad 5"},
                                                                       {4, "KiCad 4"},
                                                                       {0, "KiCad 3"}}};
    for (const auto& [first, name] : kReleases) {
        if (version >= first) {
            return std::string(name) + " (" + std::to_string(version) + ")";
        }
    }
    return "KiCad";
}

/// Hands the items of a board to those who draw them.
class BoardMaker {
public:
    BoardMaker(formats::DrawnJob& job, std::string_view file, const Project& project)
        : m_canvas(job, file), m_project(project), m_unused(m_canvas), m_footprints(m_canvas, m_unused, m_outline) {
        m_canvas.settings().variables = project.variables;
        addFileNames(file);
    }

    void take(const Item& item) {
        const std::string_view head = item.head();
        if (takeFacts(head, item) || std::ranges::find(kSilent, head) != kSilent.end()) {
            return;
        }
        settleLayers();
        if (head == "footprint" || head == "module") {
            m_footprints.draw(item);
        } else if (head == "segment" || head == "arc") {
            drawTrack(m_canvas, item);
        } else if (head == "via") {
            drawVia(m_canvas, m_unused, item);
        } else if (head == "zone") {
            drawZone(m_canvas, item);
        } else if (isGraphic(head)) {
            takeGraphic(item);
        } else if (head == "gr_text") {
            takeText(item);
        } else if (head == "dimension") {
            drawDimension(m_canvas, item, variables());
        } else if (head == "gr_text_box") {
            drawTextBox(m_canvas, item, {}, variables(), originOf(item));
        } else if (head == "table") {
            drawTable(m_canvas, item, {}, variables(), originOf(item));
        } else if (head == "target") {
            drawTarget(m_canvas, item, originOf(item));
        } else if (head == "barcode") {
            drawBarcode(m_canvas, item, variables(), originOf(item));
        } else if (head == "image") {
            m_canvas.report(Severity::Info, item.line(), "images are for the eyes of editors; they are not drawn");
        } else if (head == "variants") {
            m_canvas.reportVariants(item);
        } else {
            m_canvas.reportNotDrawn(item);
        }
    }

    bool finish() {
        settleLayers();
        reportEmptyFills(m_canvas);
        m_unused.draw();
        joinMaskOpenings(m_canvas, m_leastWeb);
        m_canvas.step().features.resize(m_canvas.job().layers.size());
        setProfile();
        setClasses();
        describe();
        return !m_canvas.layers().copper().empty();
    }

private:
    // ---- facts ----

    /// A board and its project have one name.
    void addFileNames(std::string_view file) {
        const std::string_view name = file.substr(file.rfind('/') + 1);  // npos + 1 is 0
        auto& variables = m_canvas.settings().variables;
        variables.try_emplace("FILENAME", name);
        variables.try_emplace("PROJECTNAME", name.substr(0, name.rfind('.')));
    }

    bool takeFacts(std::string_view head, const Item& item) {
        BoardSettings& settings = m_canvas.settings();
        if (head == "version") {
            settings.version = static_cast<int>(std::clamp(numberOf(item.word(1)).value_or(0.0), 0.0, 1e9));
            if (settings.version > kNewestKnown) {
                m_canvas.report(Severity::Warning, item.line(),
                                "the board is of a newer version of KiCad; what is new in it is not read");
            }
        } else if (head == "host" || head == "generator") {
            m_generator = item.text(1) + (item.word(2).empty() ? "" : " " + item.text(2));
        } else if (head == "generator_version") {
            m_generator += " " + item.text(1);
        } else if (head == "general") {
            m_thickness = length(item, "thickness");
            m_thicknessLine = item.find("thickness").line();
        } else if (head == "layers") {
            m_layersText = "(kicad_pcb " + std::string(item.source()) + ")";
        } else if (head == "setup") {
            takeSetup(item);
        } else if (head == "net") {
            m_canvas.declareNet(item);
        } else if (head == "net_class") {
            takeClass(item);
        } else if (head == "property") {
            settings.variables.try_emplace(item.text(1), item.text(2));
        } else if (head == "title_block") {
            takeTitles(item);
        } else {
            return false;
        }
        return true;
    }

    /// The stackup comes behind the layers, in an item of its own, so these wait for it.
    void settleLayers() {
        if (m_isSettled) {
            return;
        }
        m_isSettled = true;
        Diagnostics ignored;
        const std::string text = "(kicad_pcb " + m_stackupText + ")";
        BoardItems layers(m_layersText, "", ignored);
        BoardItems stackups(text, "", ignored);
        Item layerItem;
        Item stackup;
        static_cast<void>(layers.next(layerItem));
        static_cast<void>(stackups.next(stackup));
        m_canvas.layers().read(layerItem, stackup, m_canvas.settings().isOld(), m_canvas.job(), m_canvas.file());
        m_canvas.step().features.resize(m_canvas.job().layers.size());
    }

    void takeSetup(const Item& setup) {
        BoardSettings& settings = m_canvas.settings();
        settings.maskMargin = length(setup, "pad_to_mask_clearance");
        settings.pasteMargin = length(setup, "pad_to_paste_clearance");
        settings.pasteRatio = number(setup, "pad_to_paste_clearance_ratio");
        settings.viaDrill = length(setup, "via_drill");
        const Item plot = setup.find("pcbplotparams");
        settings.dashes.dash = number(plot, "dashed_line_dash_ratio", settings.dashes.dash);
        settings.dashes.gap = number(plot, "dashed_line_gap_ratio", settings.dashes.gap);
        const Item tenting = setup.find("tenting");
        if (tenting.isThere()) {
            settings.isViaTented = {tenting.isSet("front"), tenting.isSet("back")};
        } else {
            const std::string_view word = plot.find("viasonmask").word(1);
            settings.isViaTented.fill(word != "true" && word != "yes");
        }
        reportProtection(m_canvas, setup);
        const Item stackup = setup.find("stackup");
        m_stackupText = std::string(stackup.source());
        reportFinish(stackup);
        m_leastWeb = length(setup, "solder_mask_min_width");
    }

    /// What a stackup says of the whole board, which a document has no place for.
    void reportFinish(const Item& stackup) {
        for (const char* fact : {"copper_finish", "castellated_pads", "edge_plating", "edge_connector"}) {
            const Item item = stackup.find(fact);
            const std::string_view said = item.word(1);
            if (item.isThere() && said != "None" && said != "none" && said != "no") {
                m_canvas.report(Severity::Info, item.line(),
                                "what the stackup says as '" + std::string(fact) + "' is not read");
            }
        }
    }

    void takeClass(const Item& netClass) {
        for (const Item item : netClass) {
            if (item.head() == "add_net") {
                m_classes[item.text(1)] = netClass.text(1);
            }
        }
        m_hasClasses = true;
    }

    void takeTitles(const Item& titles) {
        constexpr std::array<std::pair<const char*, const char*>, 4> kTitles = {
            {{"title", "TITLE"}, {"date", "ISSUE_DATE"}, {"rev", "REVISION"}, {"company", "COMPANY"}}};
        for (const auto& [head, name] : kTitles) {
            m_canvas.settings().variables.try_emplace(name, titles.find(head).text(1));
        }
        for (const Item item : titles) {
            if (item.head() == "comment") {
                m_canvas.settings().variables.try_emplace("COMMENT" + item.text(1), item.text(2));
            }
        }
    }

    // ---- drawing ----

    void takeGraphic(const Item& item) {
        Origin origin;
        origin.line = item.line();
        origin.net = m_canvas.netOf(item);
        drawGraphic(m_canvas, item, {}, origin);
        if (item.find("layer").word(1) == "Edge.Cuts") {
            if (const std::optional<Graphic> graphic = graphicOf(m_canvas, item, {})) {
                addEdges(*graphic, m_outline);
            }
        }
    }

    static Origin originOf(const Item& item) {
        Origin origin;
        origin.line = item.line();
        return origin;
    }

    /// Those of all texts that belong to no footprint.
    [[nodiscard]] Variables variables() {
        return [this](std::string_view name) -> std::optional<std::string> {
            const auto& known = m_canvas.settings().variables;
            const auto found = known.find(name);
            return found == known.end() ? std::nullopt : std::optional(found->second);
        };
    }

    void takeText(const Item& item) {
        const std::optional<PointD> at = point(item, "at");
        if (!at) {
            m_canvas.report(Severity::Warning, item.line(), "a text has no place; it was left out");
            return;
        }
        const double degrees = numberOf(item.find("at").word(3)).value_or(0.0);
        const std::string text = shownText(m_canvas, item, item.text(1), variables());
        drawText(m_canvas, {item, text, {*at, degrees}}, originOf(item));
    }

    // ---- the end ----

    void setProfile() {
        Chains chains = chained(m_outline, kOutlineJoint);
        const bool isBoard = holdsPads(nested(chains.loops));
        const std::size_t open = chains.open.size() - (isBoard ? 0 : bridgeGaps(chains));
        m_canvas.step().profile = nested(chains.loops);
        if (open > 0) {
            m_canvas.report(Severity::Warning, 0,
                            "lines on Edge.Cuts that close no outline were left out of the board's outline");
        }
        if (chains.repeated > 0) {
            m_canvas.report(Severity::Info, 0, "lines on Edge.Cuts that are drawn again on others count once");
        }
        if (chains.widestJoint > kSameEnd) {
            m_canvas.report(Severity::Info, 0, "ends on Edge.Cuts that lie up to 10 µm apart were joined");
        }
    }

    /// Most of them, by the box of a shape. Circles within an outline that does not close are no board.
    [[nodiscard]] bool holdsPads(const ShapeSketch& shape) {
        const Box box = boxOf(shape);
        std::size_t pads = 0;
        std::size_t held = 0;
        for (const auto& features : m_canvas.step().features) {
            for (const formats::DrawnFeature& feature : features) {
                const bool isPad = feature.kind == formats::DrawnKind::Pad;
                pads += isPad ? 1 : 0;
                held += isPad && box.holds(feature.a) ? 1 : 0;
            }
        }
        return shape.contourCount() > 0 && 2 * held >= pads;
    }

    /// Adds the loops that hold most pads once their gaps are closed; gives back how many open edges are in them.
    std::size_t bridgeGaps(Chains& chains) {
        std::vector<formats::OutlineTrack> open;
        for (const std::size_t row : chains.open) {
            if (m_outline[row].from.edge != EdgeKind::Curve) {
                open.push_back({m_outline[row].from, m_outline[row].to});
            }
        }
        std::size_t count = 0;
        for (formats::BridgedLoop& loop : formats::bridgedLoops(open, kOutlineJoint)) {
            if (holdsPads(nested(std::span(&loop.nodes, 1)))) {
                m_canvas.report(Severity::Warning, 0, formats::gapsText(loop));
                chains.loops.push_back(std::move(loop.nodes));
                count += loop.trackCount;
            }
        }
        return count;
    }

    void setClasses() {
        const bool isKnown = m_hasClasses || !m_project.classOfNet.empty() || !m_project.classPatterns.empty();
        for (formats::DrawnNet& net : m_canvas.step().nets) {
            const auto own = m_classes.find(net.name);
            if (isKnown) {
                net.properties.emplace_back("net_class",
                                            own != m_classes.end() ? own->second : m_project.classOf(net.name));
            }
        }
    }

    void describe() {
        formats::DrawnJob& job = m_canvas.job();
        job.info.generator = m_generator;
        job.info.version = versionName(m_canvas.settings().version);
        job.info.units = "MM";
        if (m_thickness > 0.0 && !m_canvas.layers().hasStackup()) {
            assumeStackup();
        }
        if (m_thickness > 0.0) {
            job.boardNm = m_thickness - notOfTheBoard();
        }
    }

    /// As KiCad does, in its exports too (BOARD_STACKUP::BuildDefaultStackupList). Copper without a thickness is as it
    /// has it anyhow, and dielectrics without one share the rest.
    void assumeStackup() {
        for (formats::DrawnLayer& layer : m_canvas.job().layers) {
            if (layer.type == LayerType::SolderMask) {
                layer.facts.thicknessNm = kMaskWithoutStackup;
                layer.facts.isAssumed = true;
            }
        }
        m_canvas.report(Severity::Info, m_thicknessLine,
                        "the board has no stackup; as KiCad does, copper is taken as 35 µm and each solder mask as 10 "
                        "µm thick, and the dielectrics share evenly what they leave of the board's thickness");
    }

    /// What KiCad's thickness of a board counts and that of a document does not: the masks, also those that will be
    /// assumed, and where a single copper layer has no stackup its copper, as only its substrate counts.
    [[nodiscard]] double notOfTheBoard() {
        const bool isAlone = m_canvas.layers().copper().size() == 1 && !m_canvas.layers().hasStackup();
        double sum = isAlone ? kDefaultCopper : 0.0;
        for (const formats::DrawnLayer& layer : m_canvas.job().layers) {
            sum += layer.type == LayerType::SolderMask ? layer.facts.thicknessNm.value_or(kDefaultMask) : 0.0;
        }
        return sum;
    }

    Canvas m_canvas;
    const Project& m_project;
    std::vector<ChainEdge> m_outline;
    UnusedPads m_unused;
    Footprints m_footprints;
    std::string m_layersText;
    std::string m_stackupText;
    std::string m_generator;
    std::map<std::string, std::string, std::less<>> m_classes;
    bool m_hasClasses = false;
    bool m_isSettled = false;
    double m_thickness = 0.0;           ///< of the board, masks included
    std::uint32_t m_thicknessLine = 0;  ///< where it is said
    double m_leastWeb = 0.0;            ///< of solder mask
};

}  // namespace

base::Result<formats::DrawnJob> drawBoard(std::string_view text, std::string_view file, const Project& project,
                                          base::Progress& progress) {
    formats::DrawnJob job;
    BoardItems items(text, file, job.diagnostics);
    if (!items.isBoard()) {
        return base::Error{base::ErrorCode::BadInput, "this is no board of KiCad"};
    }
    BoardMaker maker(job, file, project);
    Item item;
    for (std::size_t count = 0; items.next(item); ++count) {
        maker.take(item);
        if (count % 256 == 0) {
            progress.setFraction(items.fractionRead());
            if (progress.isCancelled()) {
                return base::Error{base::ErrorCode::Cancelled, "cancelled"};
            }
        }
    }
    if (!maker.finish()) {
        return base::Error{base::ErrorCode::BadInput, "the board has no copper layers"};
    }
    return job;
}

}  // namespace model::kicad
