#include "model/formats/gerber/board_maker.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <unordered_map>

#include "model/formats/gerber/drill_fitting.h"
#include "model/formats/gerber/layer_order.h"
#include "model/formats/gerber/netlist_join.h"
#include "model/formats/gerber/outline.h"
#include "model/formats/gerber/parts.h"
#include "model/formats/gerber/text/words.h"
#include "model/geometry/outlines.h"

namespace model::gerber {

using formats::DrawnFeature;
using formats::DrawnKind;
using formats::kNoRow;

namespace {

constexpr Nm kHoleReach = 2'000;
constexpr Nm kPointReach = 15'000;

class BoardMaker {
public:
    BoardMaker(std::vector<ReadFile>& files, const BoardFiles& board, const std::string& jobName)
        : m_files(files), m_board(board), m_jobName(jobName), m_parts(m_step) {}

    MadeBoard run() {
        findJobFile();
        indexCopper();
        readDrillsAgain();
        m_layers = orderedLayers(m_files, m_board, m_job, m_result.job.diagnostics);
        m_step.features.resize(m_layers.layers.size());
        for (std::size_t layer = 0; layer < m_layers.layers.size(); ++layer) {
            if (m_layers.files[layer] != kNoRow) {
                addImage(layer, m_files[static_cast<std::size_t>(m_layers.files[layer])]);
            }
        }
        addPlacedComponents();
        addNetlists();
        nameHoles();
        addOutline();
        setSpans();
        finish();
        return std::move(m_result);
    }

private:
    Diagnostics& diagnostics() { return m_result.job.diagnostics; }

    void findJobFile() {
        for (const std::size_t row : m_board.files) {
            if (m_files[row].kind == ReadFile::Kind::Job) {
                m_job = m_files[row].job;
            }
        }
    }

    [[nodiscard]] bool isCopper(std::size_t row) const {
        return m_files[row].isImage() && m_files[row].role.kind == FileRole::Kind::Copper;
    }

    /// Flashes of copper, which holes and netlists are matched with.
    void indexCopper() {
        std::vector<IndexedPad> pads;
        for (const std::size_t row : m_board.files) {
            if (!isCopper(row)) {
                continue;
            }
            for (const DrawnFeature& feature : m_files[row].image.features) {
                if (feature.kind == DrawnKind::Region) {
                    m_copperBox.include(boxOf(m_files[row].image.regions[static_cast<std::size_t>(feature.region)]));
                } else {
                    m_copperBox.include(feature.a);
                }
                if (feature.kind == DrawnKind::Pad) {
                    pads.push_back({feature.a, static_cast<std::int32_t>(row), 0});
                }
            }
        }
        m_filePads = PadIndex(std::move(pads));
    }

    void readDrillsAgain() {
        std::vector<std::size_t> seen;
        for (const std::size_t row : m_board.files) {
            ReadFile& file = m_files[row];
            const bool isHoles =
                file.isImage() && (file.role.kind == FileRole::Kind::Drill || file.role.kind == FileRole::Kind::Rout);
            if (!isHoles) {
                continue;
            }
            fitToCopper(file, m_filePads, m_copperBox);
            for (const std::size_t other : seen) {
                if (file.role.source != RoleSource::Told && areSameHoles(m_files[other].image, file.image)) {
                    file.diagnostics.report(Severity::Info, file.path, 0,
                                            "another file drills the same holes; this one is shown as a document");
                    file.role = FileRole{FileRole::Kind::Document};
                    file.role.source = RoleSource::Content;
                    break;
                }
            }
            if (file.role.kind != FileRole::Kind::Document) {
                seen.push_back(row);
            }
        }
    }

    // ---- images ----

    std::int32_t netRow(const std::string& name) {
        const auto [found, isNew] = m_nets.try_emplace(name, static_cast<std::int32_t>(m_step.nets.size()));
        if (isNew) {
            m_step.nets.push_back({name, {}});
        }
        return found->second;
    }

    /// How rows of an image become rows of the step.
    struct Rows {
        std::int32_t symbols = 0;
        std::int32_t regions = 0;
        std::int32_t attributes = 0;
        std::vector<std::int32_t> nets;
        std::vector<std::int32_t> components;
    };

    Rows takeTables(Image& image) {
        Rows rows{static_cast<std::int32_t>(m_step.symbols.size()),
                  static_cast<std::int32_t>(m_step.regions.size()),
                  static_cast<std::int32_t>(m_step.attributes.size()),
                  {},
                  {}};
        std::ranges::move(image.symbols, std::back_inserter(m_step.symbols));
        std::ranges::move(image.regions, std::back_inserter(m_step.regions));
        std::ranges::move(image.attributes, std::back_inserter(m_step.attributes));
        for (const std::string& net : image.nets) {
            rows.nets.push_back(net == "N/C" ? kNoRow : netRow(net));
            m_result.hasNets = true;  // N/C says that there is none
        }
        for (const std::string& refdes : image.components) {
            rows.components.push_back(m_parts.component(refdes));
        }
        return rows;
    }

    void addImage(std::size_t layer, ReadFile& file) {
        // The outline is taken from the image once more, so that one keeps what it draws.
        Image image = file.role.kind == FileRole::Kind::Profile || file.role.kind == FileRole::Kind::Document
                          ? file.image
                          : std::move(file.image);
        const Rows rows = takeTables(image);
        const bool isCopperLayer = file.role.kind == FileRole::Kind::Copper;
        const LayerSide side = m_layers.layers[layer].side;
        const Plating plating = file.role.plating;
        for (DrawnFeature& feature : image.features) {
            feature.symbol += feature.symbol >= 0 ? rows.symbols : 0;
            feature.region += feature.region >= 0 ? rows.regions : 0;
            feature.attributes += feature.attributes >= 0 ? rows.attributes : 0;
            feature.net = feature.net >= 0 ? rows.nets[static_cast<std::size_t>(feature.net)] : kNoRow;
            settlePin(feature, image, rows, isCopperLayer, side);
            if (feature.plating == Plating::NotSaid) {
                feature.plating = plating;
            }
        }
        m_step.features[layer] = std::move(image.features);
    }

    /// Objects of components are pads of pins only on copper.
    void settlePin(DrawnFeature& feature, const Image& image, const Rows& rows, bool isCopperLayer, LayerSide side) {
        if (feature.component < 0) {
            return;
        }
        const std::int32_t component = rows.components[static_cast<std::size_t>(feature.component)];
        const bool isPad = isCopperLayer && feature.pin >= 0 && feature.kind == DrawnKind::Pad;
        const bool isThrough =
            feature.attributes >= 0 &&
            std::ranges::any_of(m_step.attributes[static_cast<std::size_t>(feature.attributes)], [](const auto& word) {
                return word.first == ".AperFunction" && word.second.starts_with("ComponentPad");
            });
        m_parts.isSeenOn(component, side, isPad, isPad && isThrough);
        feature.component = kNoRow;
        if (isCopperLayer && feature.pin >= 0) {
            const ImagePin& pin = image.pins[static_cast<std::size_t>(feature.pin)];
            const Point at = feature.kind == DrawnKind::Region ? middleOf(feature) : feature.a;
            feature.component = component;
            feature.pin = m_parts.pin(component, pin.name, at, feature.net);
        } else {
            feature.pin = kNoRow;
        }
    }

    [[nodiscard]] Point middleOf(const DrawnFeature& region) const {
        const Box box = boxOf(m_step.regions[static_cast<std::size_t>(region.region)]);
        return box.isEmpty() ? Point{} : box.middle();
    }

    // ---- components ----

    /// X3 component layers: flashes at the places of components.
    void addPlacedComponents() {
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            if (file.isImage() && file.role.kind == FileRole::Kind::Components) {
                PlacementFile placed;
                for (const DrawnFeature& feature : file.image.features) {
                    addX3(file, feature, placed);
                }
                m_parts.place(placed, file.path, m_filePads, m_copperBox, diagnostics());
            }
        }
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            if (file.kind == ReadFile::Kind::Placements) {
                m_parts.place(file.placements, file.path, m_filePads, m_copperBox, diagnostics());
            }
        }
    }

    void addX3(const ReadFile& file, const DrawnFeature& feature, PlacementFile& placed) {
        if (feature.kind != DrawnKind::Pad || feature.component < 0) {
            return;
        }
        const std::string& refdes = file.image.components[static_cast<std::size_t>(feature.component)];
        if (feature.pin >= 0) {
            const std::int32_t component = m_parts.component(refdes);
            (void)m_parts.pin(
                component, file.image.pins[static_cast<std::size_t>(feature.pin)].name, feature.a,
                feature.net < 0 ? kNoRow : netRow(file.image.nets[static_cast<std::size_t>(feature.net)]));
            return;
        }
        PlacedPart part;
        part.refdes = refdes;
        part.position = feature.a;
        part.side = file.role.side;
        part.line = feature.line;
        const formats::Words none;
        const formats::Words& words =
            feature.attributes < 0 ? none : file.image.attributes[static_cast<std::size_t>(feature.attributes)];
        for (const auto& [name, value] : words) {
            if (name == ".CRot") {
                part.rotationDeg = parseReal(value).value_or(0.0);
            } else if (name == ".CVal") {
                part.value = value;
            } else if (name == ".CFtp") {
                part.package = value;
            }
        }
        placed.parts.push_back(std::move(part));
    }

    // ---- nets from netlists ----

    void addNetlists() {
        indexPads();
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            if (file.kind != ReadFile::Kind::Netlist) {
                continue;
            }
            const std::optional<Point> shift = shiftOf(file.netlist, m_pads);
            if (!shift) {
                diagnostics().report(
                    Severity::Warning, file.path, 0,
                    "the points of the netlist lie on no pads, wherever its origin is taken to be; it is "
                    "not used");
                continue;
            }
            if (*shift != Point{}) {
                diagnostics().report(Severity::Info, file.path, 0,
                                     "the netlist counts from another origin, found by matching its points with pads");
            }
            const std::vector<std::string> names = fullNames(file.netlist.nets, m_step.nets);
            if (!m_result.hasNets) {
                diagnostics().report(
                    Severity::Info, file.path, 0,
                    "the images name no nets; those of the netlist are given to the pads at its points");
                for (const D356Point& point : file.netlist.points) {
                    giveNet(point, names, *shift);
                }
            }
            m_step.netlists.push_back(drawnNetlist(file.netlist, names, *shift, file.path));
        }
    }

    void giveNet(const D356Point& point, const std::vector<std::string>& names, Point shift) {
        const Point at{point.position.x + shift.x, point.position.y + shift.y};
        const std::int32_t net = point.net < 0 ? kNoRow : netRow(names[static_cast<std::size_t>(point.net)]);
        const bool isPin = !point.isVia && !point.refdes.empty() && point.isPlated;
        const std::int32_t component = isPin ? m_parts.component(point.refdes) : kNoRow;
        const LayerSide side = point.access == 0   ? LayerSide::Through
                               : point.access == 1 ? LayerSide::Top
                                                   : LayerSide::Bottom;
        m_pads.visit(at, kPointReach, [&](const IndexedPad& pad) {
            const LayerSide padSide = m_layers.layers[static_cast<std::size_t>(pad.layer)].side;
            if (side != LayerSide::Through && side != padSide) {
                return;
            }
            DrawnFeature& feature =
                m_step.features[static_cast<std::size_t>(pad.layer)][static_cast<std::size_t>(pad.feature)];
            if (feature.net < 0) {
                feature.net = net;
            }
            if (isPin && feature.component < 0) {
                feature.component = component;
                feature.pin = m_parts.pin(component, point.pin, feature.a, net);
                m_parts.isSeenOn(component, side == LayerSide::Through ? LayerSide::None : padSide, true,
                                 point.hole > 0);
            } else if (point.isVia) {
                feature.subnet = SubnetKind::Via;
            }
        });
    }

    /// Flashes on the copper layers of the step.
    void indexPads() {
        std::vector<IndexedPad> pads;
        for (const std::int32_t layer : m_layers.copper) {
            const std::vector<DrawnFeature>& features = m_step.features[static_cast<std::size_t>(layer)];
            for (std::size_t i = 0; i < features.size(); ++i) {
                if (features[i].kind == DrawnKind::Pad && !features[i].isNegative) {
                    pads.push_back({features[i].a, layer, static_cast<std::int32_t>(i)});
                }
            }
        }
        m_pads = PadIndex(std::move(pads));
    }

    /// Plated holes have the net of the pads around them, and what these are.
    void nameHoles() {
        for (std::size_t layer = 0; layer < m_layers.layers.size(); ++layer) {
            const LayerType type = m_layers.layers[layer].type;
            if (type != LayerType::Drill && type != LayerType::Rout) {
                continue;
            }
            for (DrawnFeature& hole : m_step.features[layer]) {
                if (hole.plating == Plating::NonPlated) {
                    continue;
                }
                const Point at = hole.kind == DrawnKind::Line
                                     ? Point{hole.a.x / 2 + hole.b.x / 2, hole.a.y / 2 + hole.b.y / 2}
                                     : hole.a;
                bool isVia = false;
                m_pads.visit(at, kHoleReach, [&](const IndexedPad& pad) {
                    const DrawnFeature& flash =
                        m_step.features[static_cast<std::size_t>(pad.layer)][static_cast<std::size_t>(pad.feature)];
                    hole.net = hole.net < 0 ? flash.net : hole.net;
                    isVia = isVia || flash.subnet == SubnetKind::Via;
                });
                if (isVia) {
                    hole.plating = Plating::Via;
                }
            }
        }
    }

    // ---- outline, spans, names ----

    void addOutline() {
        std::optional<Outline> best;
        std::string path;
        std::vector<Point> copper;
        for (const IndexedPad& pad : m_filePads.pads()) {
            copper.push_back(pad.position);
        }
        for (const bool isTold : {true, false}) {
            if (best) {
                break;
            }
            for (const std::size_t row : m_board.files) {
                const ReadFile& file = m_files[row];
                const bool isCandidate =
                    file.isImage() && file.kind == ReadFile::Kind::Gerber &&
                    (file.role.kind == FileRole::Kind::Profile) == isTold &&
                    (isTold || file.role.kind == FileRole::Kind::Document || file.role.kind == FileRole::Kind::Unknown);
                if (best || !isCandidate) {
                    continue;
                }
                Outline outline = outlineOf(file.image, copper);
                if (isTold) {
                    reportOutline(file, outline);
                }
                if (!outline.shape.isEmpty() && (isTold ? mayBe(outline.box) : fits(outline.box))) {
                    best = std::move(outline);
                    path = file.path;
                }
            }
            if (best && !isTold) {
                diagnostics().report(
                    Severity::Info, path, 0,
                    "no file is named as the board's outline; taken from this one, whose loops enclose the "
                    "copper closely");
            }
        }
        if (best) {
            m_step.profile = std::move(best->shape);
            m_step.profileFile = path;
        }
    }

    void reportOutline(const ReadFile& file, const Outline& outline) {
        if (outline.openTracks > 0) {
            diagnostics().report(Severity::Warning, file.path, 0,
                                 "some lines of the board's outline do not close; they are left out of it");
        }
        if (outline.isDrawing) {
            diagnostics().report(
                Severity::Warning, file.path, 0,
                "loops within the board's outline hold copper, or are too many for cut-outs; they were "
                "taken for a drawing");
        }
        if (outline.widestJoint > 1'000) {
            diagnostics().report(Severity::Info, file.path, 0,
                                 "lines of the board's outline do not meet exactly; they were joined");
        }
    }

    /// Not a symbol in a corner of a drawing.
    [[nodiscard]] bool mayBe(const Box& box) const {
        return m_copperBox.isEmpty() ||
               (box.width() * 2 > m_copperBox.width() && box.height() * 2 > m_copperBox.height());
    }

    /// Encloses the copper, and not much more.
    [[nodiscard]] bool fits(const Box& box) const {
        const Box grown = box.grownBy(100'000);
        const auto area = [](const Box& b) { return static_cast<double>(b.width()) * static_cast<double>(b.height()); };
        return !m_copperBox.isEmpty() && grown.holds(m_copperBox.min) && grown.holds(m_copperBox.max) &&
               area(box) < 2.0 * area(m_copperBox) + 1e12;
    }

    /// Spans count copper layers from the top; without one a drill passes all of them.
    void setSpans() {
        const auto count = static_cast<int>(m_layers.copper.size());
        for (std::size_t layer = 0; layer < m_layers.layers.size(); ++layer) {
            if (m_layers.files[layer] == kNoRow) {
                continue;
            }
            const ReadFile& file = m_files[static_cast<std::size_t>(m_layers.files[layer])];
            const int top = std::min(file.role.spanTop, file.role.spanBottom);
            const int bottom = std::max(file.role.spanTop, file.role.spanBottom);
            if (top < 1) {
                continue;
            }
            if (bottom > count) {
                diagnostics().report(Severity::Warning, file.path, 0,
                                     "the drills pass more copper layers than the board has; taken as all of them");
                continue;
            }
            m_layers.layers[layer].spanTop = m_layers.copper[static_cast<std::size_t>(top - 1)];
            m_layers.layers[layer].spanBottom = m_layers.copper[static_cast<std::size_t>(bottom - 1)];
        }
    }

    void finish() {
        m_step.componentsFile = m_step.componentsFile.empty() && !m_layers.copper.empty()
                                    ? m_layers.layers[static_cast<std::size_t>(m_layers.copper[0])].file
                                    : m_step.componentsFile;
        m_parts.finish(diagnostics());
        formats::DrawnJob& job = m_result.job;
        m_step.name = m_board.name.empty() ? "board" : m_board.name;
        job.layers = std::move(m_layers.layers);
        job.boardNm = m_job.boardNm;
        job.info.name = !m_job.name.empty() ? m_job.name : m_jobName;
        job.info.generator = m_job.generator;
        job.info.version = "Gerber";
        for (const std::size_t row : m_board.files) {
            const ReadFile& file = m_files[row];
            const bool saysMore = job.info.generator.empty() && file.isImage();
            if (saysMore) {
                job.info.generator = std::string(file.image.fileAttribute(".GenerationSoftware"));
                std::ranges::replace(job.info.generator, ',', ' ');
            }
        }
        Diagnostics all;
        for (const std::size_t row : m_board.files) {
            all.append(m_files[row].image.diagnostics);
            all.append(m_files[row].diagnostics);
        }
        all.append(job.diagnostics);
        job.diagnostics = std::move(all);
        job.info.units = "MM";
        job.steps.push_back(std::move(m_step));
    }

    std::vector<ReadFile>& m_files;
    const BoardFiles& m_board;
    const std::string& m_jobName;
    MadeBoard m_result;
    formats::DrawnStep m_step;
    JobFileFacts m_job;
    OrderedLayers m_layers;
    Box m_copperBox;
    PadIndex m_filePads;  ///< before layers are ordered
    PadIndex m_pads;      ///< by layer and feature of the step
    std::unordered_map<std::string, std::int32_t> m_nets;
    PartList m_parts;
};

}  // namespace

MadeBoard makeBoard(std::vector<ReadFile>& files, const BoardFiles& board, const std::string& jobName) {
    return BoardMaker(files, board, jobName).run();
}

}  // namespace model::gerber
