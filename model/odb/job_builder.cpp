#include "model/odb/job_builder.h"

#include <algorithm>

#include "model/body.h"
#include "model/odb/element_maker.h"
#include "model/odb/layer_table.h"
#include "model/odb/net_links.h"
#include "model/odb/painting.h"
#include "model/odb/profile.h"
#include "model/odb/records.h"
#include "model/odb/region.h"

namespace model::odb {

namespace {

class JobBuilder {
public:
    JobBuilder(const JobContext& job, const Steps& steps, DocumentBuilder& builder, base::Progress& progress)
        : m_matrix(job.matrix),
          m_steps(steps),
          m_builder(builder),
          m_progress(progress),
          m_symbols(job.tree, job.defaultUnit, builder.diagnostics()),
          m_layers(job, steps, builder) {}

    bool build(std::optional<double> boardNm) {
        takeDiagnostics();
        m_layers.add(boardNm);
        m_copies = unfoldCopies(m_steps, diagnostics());
        m_nets.emplace(m_builder, m_matrix, m_steps);
        if (!buildLayers(false)) {
            return false;
        }
        setProfile();
        if (!buildLayers(true)) {
            return false;
        }
        reportPlating();
        addTools();
        addComponents();
        addBody(m_builder);
        return true;
    }

private:
    Diagnostics& diagnostics() { return m_builder.diagnostics(); }

    void takeDiagnostics() {
        for (const StepData& step : m_steps) {
            diagnostics().append(step.header.diagnostics);
            diagnostics().append(step.profile.diagnostics);
            diagnostics().append(step.eda.diagnostics);
            for (const StepLayer& layer : step.layers) {
                diagnostics().append(layer.features.diagnostics);
                diagnostics().append(layer.thickness.diagnostics);
                diagnostics().append(layer.tools.diagnostics);
                diagnostics().append(layer.components.diagnostics);
            }
        }
    }

    // ---- elements ----

    /// All layers whose polarity is `isNegative`; negative ones need the profile, so they come last.
    bool buildLayers(bool isNegative) {
        for (const std::size_t row : m_layers.order()) {
            if (m_progress.isCancelled()) {
                return false;
            }
            if (m_matrix.layers[row].isNegative == isNegative) {
                buildLayer(row);
                m_progress.setFraction(static_cast<float>(++m_built) / static_cast<float>(m_layers.order().size()));
            }
        }
        return true;
    }

    void buildLayer(std::size_t row) {
        const MatrixLayer& layer = m_matrix.layers[row];
        const std::vector<FeatureSource> sources = sourcesOf(row);
        m_builder.beginLayer(m_layers.id(row));
        if (sources.empty()) {
            return;
        }
        std::optional<HoleRules> holes;
        if (layer.isHoles()) {
            holes.emplace(layer.type, toolsOf(row));
        }
        const bool hasNegatives =
            std::ranges::any_of(sources, [](const FeatureSource& source) { return source.file->hasNegatives; });
        if (layer.isNegative || hasNegatives) {
            return paintLayer(row, sources, holes ? &*holes : nullptr);
        }
        ElementMaker maker(m_builder, m_symbols, diagnostics());
        for (const FeatureSource& source : sources) {
            maker.add(source, holes ? &*holes : nullptr);
        }
    }

    void paintLayer(std::size_t row, const std::vector<FeatureSource>& sources, const HoleRules* holes) {
        DocumentBuilder scratch;
        scratch.beginLayer(scratch.addLayer({}));
        ElementMaker maker(scratch, m_symbols, diagnostics());
        for (const FeatureSource& source : sources) {
            maker.add(source, holes);
        }
        if (!m_matrix.layers[row].isNegative) {
            return addPainted(m_builder, scratch.soFar(), maker.negatives());
        }
        const ShapeId profile = m_builder.soFar().profile;
        if (!profile.isValid()) {
            diagnostics().report(
                Severity::Error, "matrix/matrix", m_matrix.layers[row].line,
                "layer " + m_matrix.layers[row].name + " is negative, but the board has no outline; it stays empty");
            return;
        }
        diagnostics().report(
            Severity::Info, "matrix/matrix", m_matrix.layers[row].line,
            "layer " + m_matrix.layers[row].name +
                " is negative: shown is the board's outline minus its features; its pieces carry no nets");
        addInverse(m_builder, discretise(m_builder.shapes(), profile, kBooleanChords), scratch.soFar(),
                   maker.negatives());
    }

    std::vector<Tool> toolsOf(std::size_t row) const {
        std::vector<Tool> tools;
        for (const StepData& step : m_steps) {
            tools.insert(tools.end(), step.layers[row].tools.value.begin(), step.layers[row].tools.value.end());
        }
        return tools;
    }

    /// The features that land on a layer: those of every copy, flipped ones from the layer on the other side.
    std::vector<FeatureSource> sourcesOf(std::size_t row) {
        std::vector<FeatureSource> sources;
        for (const StepCopy& copy : m_copies) {
            const std::size_t from = copy.isFlipped ? m_layers.oppositeRow(row) : row;
            const Parsed<FeatureFile>& features = m_steps[copy.step].layers[from].features;
            if (features.isPresent() && isInRange(copy, features)) {
                sources.push_back({&features.value, features.path, copy.placement, m_nets->netsOf(copy.step, from)});
            }
        }
        return sources;
    }

    /// Copies must not leave the coordinate range.
    bool isInRange(const StepCopy& copy, const Parsed<FeatureFile>& features) {
        if (isIdentity(copy.placement)) {
            return true;
        }
        const Box extent = extentOf(features.value);
        const double reach = base::kMaxCoordinate;
        for (const Point corner :
             {extent.min, {extent.max.x, extent.min.y}, extent.max, {extent.min.x, extent.max.y}}) {
            const PointD placed = copy.placement.apply(base::toDouble(corner));
            if (!extent.isEmpty() && (std::abs(placed.x) > reach || std::abs(placed.y) > reach)) {
                diagnostics().report(Severity::Error, features.path, 0,
                                     "a panel copy lies outside of the coordinate range of ±1.07 m; it was left out");
                return false;
            }
        }
        return true;
    }

    const Box& extentOf(const FeatureFile& file) {
        const auto [place, isNew] = m_extents.try_emplace(&file);
        if (isNew) {
            for (const Feature& feature : file.features) {
                if (feature.kind == FeatureKind::Surface) {
                    place->second.include(file.surfaces.shapes[feature.index].box);
                } else if (feature.kind != FeatureKind::Bad && feature.kind != FeatureKind::Text) {
                    place->second.include(feature.a);
                    place->second.include(feature.kind == FeatureKind::Pad ? feature.a : feature.b);
                }
            }
        }
        return place->second;
    }

    // ---- profile ----

    void setProfile() {
        const Parsed<FeatureFile>& file = m_steps[0].profile;
        std::optional<ShapeSketch> sketch = profileOf(file.value);
        const bool isBelieved = sketch && fitsCopper(*sketch, m_builder.soFar());
        if (!isBelieved) {
            const std::string why = sketch             ? "the profile does not enclose the copper"
                                    : file.isPresent() ? "the profile holds no outline"
                                                       : "the step has no profile";
            sketch = profileFromCopper(m_builder.soFar());
            diagnostics().report(Severity::Warning, file.isPresent() ? file.path : m_steps[0].folder + "/profile", 0,
                                 why + (sketch ? "; the box around all copper is used as the board's outline"
                                               : "; the board has no outline"));
        }
        if (sketch) {
            m_builder.setProfile(m_builder.addShape(*sketch));
        }
    }

    // ---- the rest ----

    void reportPlating() {
        const std::vector<std::uint8_t>& flags = m_builder.soFar().elements.flags;
        if (std::ranges::any_of(flags, [](std::uint8_t f) { return (f & kPlated) != 0; })) {
            diagnostics().report(Severity::Info, "", 0,
                                 "the job does not say how thick the copper in plated holes is; taken as 25 µm");
        }
    }

    void addTools() {
        for (const std::size_t row : m_layers.order()) {
            for (const Tool& tool : toolsOf(row)) {
                m_builder.addTool({m_layers.id(row), tool.number, tool.type, tool.finishedSize, tool.drillSize});
            }
        }
    }

    void addComponents() {
        for (std::size_t row = 0; row < m_matrix.layers.size(); ++row) {
            const LayerSide side = m_builder.layer(m_layers.id(row)).side;
            for (const PlacedComponent& component : m_steps[0].layers[row].components.value) {
                addComponent(component, side);
            }
        }
        if (m_copies.size() > 1) {
            diagnostics().report(
                Severity::Info, m_steps[0].header.path, 0,
                "the step repeats others: nets are shared by all copies, components of the copies are left out");
        }
    }

    void addComponent(const PlacedComponent& source, LayerSide side) {
        const std::vector<EdaPackage>& packages = m_steps[0].eda.value.packages;
        const bool isKnown = source.package >= 0 && static_cast<std::size_t>(source.package) < packages.size();
        const EdaPackage* package = isKnown ? &packages[static_cast<std::size_t>(source.package)] : nullptr;
        std::vector<Pin> pins;
        for (const PlacedPin& pin : source.pins) {
            pins.push_back({pinName(pin, package), pin.position, m_nets->net(0, pin.net)});
        }
        Component component;
        component.refdes = source.refdes;
        component.part = source.part;
        component.package = package != nullptr ? package->name : "";
        component.position = source.position;
        component.clockwiseDeg = source.clockwiseDeg;
        component.isMirrored = source.isMirrored;
        component.side = side;
        m_builder.addComponent(std::move(component), pins);
    }

    static std::string pinName(const PlacedPin& pin, const EdaPackage* package) {
        const bool isListed =
            package != nullptr && pin.number >= 0 && static_cast<std::size_t>(pin.number) < package->pins.size();
        return pin.name.empty() && isListed ? package->pins[static_cast<std::size_t>(pin.number)] : pin.name;
    }

    const Matrix& m_matrix;
    const Steps& m_steps;
    DocumentBuilder& m_builder;
    base::Progress& m_progress;
    SymbolLibrary m_symbols;
    LayerTable m_layers;
    std::vector<StepCopy> m_copies;
    std::optional<NetLinks> m_nets;
    std::map<const FeatureFile*, Box> m_extents;
    std::size_t m_built = 0;
};

}  // namespace

bool buildJob(const JobContext& job, const Steps& steps, std::optional<double> boardNm, DocumentBuilder& builder,
              base::Progress& progress) {
    return JobBuilder(job, steps, builder, progress).build(boardNm);
}

}  // namespace model::odb
