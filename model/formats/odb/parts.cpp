#include "model/formats/odb/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>

#include "model/formats/odb/text/records.h"
#include "model/formats/steps/elements_of_feature.h"
#include "model/geometry/outlines.h"
#include "model/packages/body_size.h"

namespace model::odb {

namespace {

/// How far a placed pin may be from its record: rotations and inch coordinates are rounded.
constexpr Nm kPinTolerance = 1'000;

bool isNear(Point a, Point b) {
    return std::abs(std::int64_t{a.x} - b.x) <= kPinTolerance && std::abs(std::int64_t{a.y} - b.y) <= kPinTolerance;
}

bool hasAttribute(const PlacedComponent& component, std::string_view name) {
    return std::ranges::find(component.properties, name, &TextProperty::name) != component.properties.end();
}

MountType mountOf(const PlacedComponent& component) {
    constexpr std::array<std::pair<std::string_view, MountType>, 8> kWords{{{"other", MountType::Other},
                                                                            {"smt", MountType::Surface},
                                                                            {"thmt", MountType::ThroughHole},
                                                                            {"thru", MountType::ThroughHole},
                                                                            {"pressfit", MountType::PressFit},
                                                                            {"press_fit", MountType::PressFit},
                                                                            {"merged", MountType::Other},
                                                                            {"not_def", MountType::Unknown}}};
    const auto found = std::ranges::find(component.properties, ".comp_mount_type", &TextProperty::name);
    for (const auto& [word, type] : kWords) {
        if (found != component.properties.end() && equalsIgnoringCase(found->value, word)) {
            return type;
        }
    }
    return MountType::Unknown;
}

/// The same package seen from below: y to -y, as KiCad flips what is on the bottom.
EdaPackage flipped(const EdaPackage& package) {
    const Placement over{{}, 180.0, true};
    const auto outline = [&](const ShapeSketch& from) {
        ShapeSketch to;
        to.append(from, over);
        return to;
    };
    EdaPackage turned = package;
    turned.box = over.boxOf(package.box);
    turned.outline = outline(package.outline);
    for (EdaPin& pin : turned.pins) {
        pin.position = over.apply(pin.position);
        pin.outline = outline(pin.outline);
    }
    return turned;
}

class PartsMaker {
public:
    PartsMaker(DocumentBuilder& builder, const Matrix& matrix, const LayerTable& layers, const StepData& step,
               const NetLinks& nets)
        : m_builder(builder), m_matrix(matrix), m_layers(layers), m_step(step), m_nets(nets) {}

    void run() {
        m_packages.resize(m_step.eda.value.packages.size());
        for (std::size_t row = 0; row < m_matrix.layers.size(); ++row) {
            const Parsed<std::vector<PlacedComponent>>& file = m_step.layers[row].components;
            if (!file.value.empty()) {
                const LayerSide side = m_builder.layer(m_layers.id(row)).side;
                m_lists.push_back({&file, side, pinsAreMirrored(file.value, side)});
            }
        }
        addPackages();
        for (const List& list : m_lists) {
            reportFlipped(list);
            const std::size_t first = m_toeprints.size();
            for (const PlacedComponent& component : list.file->value) {
                add(component, list);
            }
            count(list, first);
        }
        tiePinPads();
    }

private:
    /// The components of a side.
    struct List {
        const Parsed<std::vector<PlacedComponent>>* file = nullptr;
        LayerSide side = LayerSide::None;
        bool isMirrored = false;  ///< as its pins lie

        /// Is the component said to be mirrored, and its package drawn as if seen through the board?
        [[nodiscard]] bool isFlipped(const PlacedComponent& component) const {
            return side == LayerSide::Bottom && component.isMirrored && !isMirrored;
        }
    };
    /// A package as it is drawn, and as it is where it is flipped; none where no component needs it.
    struct BothWays {
        PackageId drawn;
        PackageId flipped;
    };

    /// Of two lists of a side, subnets can mean one alone: the first.
    void count(const List& list, std::size_t first) {
        auto& counted = m_counted[list.side == LayerSide::Bottom];
        if (counted.second > counted.first) {
            m_builder.diagnostics().report(Severity::Warning, list.file->path, list.file->value.front().line,
                                           "another list of components on this side: eda/data counts those of the "
                                           "first list, so pads are not tied to the pins of these");
            return;
        }
        counted = {first, m_toeprints.size()};
    }

    [[nodiscard]] const EdaPackage* packageOf(const PlacedComponent& component) const {
        const std::vector<EdaPackage>& packages = m_step.eda.value.packages;
        const bool isKnown = component.package >= 0 && static_cast<std::size_t>(component.package) < packages.size();
        return isKnown ? &packages[static_cast<std::size_t>(component.package)] : nullptr;
    }

    [[nodiscard]] static const EdaPin* pinOf(const EdaPackage* package, const PlacedPin& pin) {
        const bool isKnown =
            package != nullptr && pin.number >= 0 && static_cast<std::size_t>(pin.number) < package->pins.size();
        return isKnown ? &package->pins[static_cast<std::size_t>(pin.number)] : nullptr;
    }

    ShapeId shapeOf(const ShapeSketch& sketch) { return sketch.isEmpty() ? ShapeId{} : m_builder.addShape(sketch); }

    void addPackages() {
        const std::vector<EdaPackage>& packages = m_step.eda.value.packages;
        std::vector<std::array<bool, 2>> uses(packages.size());
        for (const List& list : m_lists) {
            for (const PlacedComponent& component : list.file->value) {
                if (packageOf(component) != nullptr) {
                    uses[static_cast<std::size_t>(component.package)][list.isFlipped(component)] = true;
                }
            }
        }
        for (std::size_t i = 0; i < packages.size(); ++i) {
            const auto [isDrawn, isFlipped] = uses[i];
            if (isDrawn || !isFlipped) {
                m_packages[i].drawn = addPackage(packages[i]);
            }
            if (isFlipped) {
                m_packages[i].flipped = addPackage(flipped(packages[i]));
            }
        }
    }

    PackageId addPackage(const EdaPackage& from) {
        std::vector<PackagePin> pins;
        for (const EdaPin& pin : from.pins) {
            pins.push_back({m_builder.string(pin.name), pin.kind, pin.position, shapeOf(pin.outline)});
        }
        Package package;
        package.name = from.name;
        package.pitch = from.pitch;
        package.box = from.box;
        package.body = shapeOf(from.outline);
        package.properties = addProperties(m_builder, from.properties);
        return m_builder.addPackage(std::move(package), pins);
    }

    /// How many of a component's pins a placement puts where their records say.
    [[nodiscard]] std::size_t fittingPins(const PlacedComponent& component, bool isMirrored) const {
        const EdaPackage* package = packageOf(component);
        const Placement placement{component.position, component.clockwiseDeg, isMirrored};
        return static_cast<std::size_t>(std::ranges::count_if(component.pins, [&](const PlacedPin& pin) {
            const EdaPin* known = pinOf(package, pin);
            return known != nullptr && isNear(placement.apply(known->position), pin.position);
        }));
    }

    [[nodiscard]] bool pinsAreMirrored(const std::vector<PlacedComponent>& components, LayerSide side) const {
        std::size_t plain = 0;
        std::size_t mirrored = 0;
        for (const PlacedComponent& component : components) {
            plain += fittingPins(component, false);
            mirrored += fittingPins(component, true);
        }
        return plain == mirrored ? side == LayerSide::Bottom : mirrored > plain;
    }

    void reportFlipped(const List& list) {
        const auto& parts = list.file->value;
        const auto first =
            std::ranges::find_if(parts, [&](const PlacedComponent& part) { return list.isFlipped(part); });
        if (first != parts.end()) {
            m_builder.diagnostics().report(Severity::Info, list.file->path, first->line,
                                           "packages on the bottom are drawn as seen through the board; they were "
                                           "flipped, and their parts' rotations with them");
        }
    }

    void add(const PlacedComponent& from, const List& list) {
        const EdaPackage* package = packageOf(from);
        const bool isFlipped = list.isFlipped(from);
        PackageId id;
        if (package != nullptr) {
            const BothWays& ways = m_packages[static_cast<std::size_t>(from.package)];
            id = isFlipped ? ways.flipped : ways.drawn;
        }
        checkNumbers(from, package, list);
        std::vector<Pin> pins;
        std::size_t known = 0;
        for (const PlacedPin& pin : from.pins) {
            pins.push_back(pinFrom(pin, package, id, from.refdes));
            known += pinOf(package, pin) != nullptr ? 1 : 0;
        }
        if (fittingPins(from, list.isMirrored) < known) {
            m_builder.diagnostics().report(Severity::Warning, list.file->path, from.line,
                                           "the pins of a component do not lie where its package puts them; they stay "
                                           "where the TOP records say");
        }
        Component component;
        component.refdes = from.refdes;
        component.part = from.part;
        component.package = id;
        component.placement = {from.position, from.clockwiseDeg, list.isMirrored};
        if (isFlipped) {
            component.placement = {from.position, std::fmod(540.0 - from.clockwiseDeg, 360.0), true};
        }
        component.side = list.side;
        component.height = from.height;
        component.mount = mountOf(from);
        component.isPopulated = !hasAttribute(from, ".no_pop");
        component.properties = addProperties(m_builder, from.properties);
        m_toeprints.push_back(&from);
        m_builder.addComponent(std::move(component), pins);
    }

    /// Numbers of packages, pins and nets count records of eda/data; -1 says that there is none. A step without that
    /// file was reported.
    void checkNumbers(const PlacedComponent& from, const EdaPackage* package, const List& list) {
        const auto report = [&](std::uint32_t line, std::string_view text) {
            m_builder.diagnostics().report(Severity::Warning, list.file->path, line, text);
        };
        if (!from.refdes.empty() && !m_refdes.insert(from.refdes).second) {
            report(from.line, "another component has the same reference designator; both are kept");
        }
        if (!m_step.eda.isPresent()) {
            return;
        }
        if (package == nullptr && from.package != -1) {
            report(from.line, "the component names a package that eda/data does not have; it has none");
        }
        for (const PlacedPin& pin : from.pins) {
            if (package != nullptr && pin.number != -1 && pinOf(package, pin) == nullptr) {
                report(pin.line, "TOP: the package has no pin of that number; the pin stays without its outline");
            }
            const auto nets = static_cast<std::int64_t>(m_step.eda.value.nets.size());
            if (pin.net < -1 || pin.net >= nets) {
                report(pin.line, "TOP: eda/data has no net of that number; the pin has no net");
            }
        }
    }

    /// Older versions of Altium write the designator of the part in front of the pin: "J44-1" for pin 1 of J44.
    static std::string_view nameOf(const PlacedPin& pin, const EdaPin* known, std::string_view refdes) {
        if (known == nullptr || known->name.empty()) {
            return pin.name;
        }
        const bool isBoth = pin.name.size() == refdes.size() + 1 + known->name.size() && pin.name.starts_with(refdes) &&
                            pin.name[refdes.size()] == '-' && pin.name.ends_with(known->name);
        return pin.name.empty() || isBoth ? known->name : pin.name;
    }

    Pin pinFrom(const PlacedPin& from, const EdaPackage* package, PackageId id, std::string_view refdes) {
        const EdaPin* known = pinOf(package, from);
        Pin pin;
        pin.name = m_builder.string(nameOf(from, known, refdes));
        pin.position = from.position;
        pin.net = m_nets.net(from.net);
        if (known != nullptr) {
            pin.packagePin = m_builder.soFar().packages[id.row()].pins.first + static_cast<std::uint32_t>(from.number);
        }
        return pin;
    }

    void tiePinPads() {
        const std::vector<EdaSubnet>& subnets = m_step.eda.value.subnets;
        for (std::size_t row = 0; row < subnets.size(); ++row) {
            const SubnetId id = m_nets.subnets()[row];
            if (subnets[row].kind == SubnetKind::PinPads && id.isValid()) {
                m_builder.subnet(id).pin = pinOf(subnets[row]);
            }
        }
    }

    [[nodiscard]] PinId pinOf(const EdaSubnet& subnet) const {
        const auto [begin, end] = m_counted[subnet.side == LayerSide::Bottom];
        const auto first = m_toeprints.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last = m_toeprints.begin() + static_cast<std::ptrdiff_t>(end);
        const auto named = std::lower_bound(
            first, last, subnet.component,
            [](const PlacedComponent* component, std::int32_t number) { return component->number < number; });
        if (named == last || (*named)->number != subnet.component) {
            return {};
        }
        const std::vector<PlacedPin>& pins = (*named)->pins;
        const auto found = std::ranges::find(pins, subnet.toeprint, &PlacedPin::number);
        const Component& component =
            m_builder.soFar().components[static_cast<std::size_t>(named - m_toeprints.begin())];
        return found == pins.end() ? PinId{}
                                   : PinId{component.firstPin + static_cast<std::size_t>(found - pins.begin())};
    }

    DocumentBuilder& m_builder;
    const Matrix& m_matrix;
    const LayerTable& m_layers;
    const StepData& m_step;
    const NetLinks& m_nets;
    std::vector<List> m_lists;
    std::vector<BothWays> m_packages;                 ///< by number of the PKG record
    std::vector<const PlacedComponent*> m_toeprints;  ///< by component
    std::set<std::string> m_refdes;                   ///< seen so far
    /// Components that subnets of the top and of the bottom count: the first one and that behind the last one.
    std::array<std::pair<std::size_t, std::size_t>, 2> m_counted{};
};

}  // namespace

void addParts(DocumentBuilder& builder, const Matrix& matrix, const LayerTable& layers, const StepData& step,
              const NetLinks& nets) {
    PartsMaker(builder, matrix, layers, step, nets).run();
}

namespace {

/// The height a component's body will have, or a little more: outlines are taken for their boxes.
Nm heightOf(const PlacedComponent& component, const std::vector<EdaPackage>& packages, const Document& document) {
    PackageFacts facts;
    facts.refdes = component.refdes;
    facts.boardDepth = document.boardThickness;
    const bool isKnown = component.package >= 0 && static_cast<std::size_t>(component.package) < packages.size();
    if (!isKnown) {
        for (const PlacedPin& pin : component.pins) {
            facts.addPin(pin.position, {}, mountOf(component) == MountType::ThroughHole);
        }
        return sizeBody(facts, component.height).height;
    }
    const EdaPackage& package = packages[static_cast<std::size_t>(component.package)];
    facts.name = package.name;
    for (const EdaPin& pin : package.pins) {
        facts.addPin(pin.position, boxOf(pin.outline), pin.kind == PinKind::Through);
    }
    facts.setOutline({}, boxOf(package.outline), package.box);
    return sizeBody(facts, component.height).height;
}

}  // namespace

TallestBodies tallestParts(const Matrix& matrix, const LayerTable& layers, const Steps& steps,
                           const Document& document) {
    TallestBodies tallest;
    tallest.isAlone = steps.size() == 1;
    for (const StepData& step : steps) {
        for (std::size_t row = 0; row < matrix.layers.size(); ++row) {
            for (const PlacedComponent& component : step.layers[row].components.value) {
                const bool isBottom = document.layer(layers.id(row)).side == LayerSide::Bottom;
                Nm& side = isBottom ? tallest.bottom : tallest.top;
                side = std::max(side, heightOf(component, step.eda.value.packages, document));
            }
        }
    }
    return tallest;
}

void addGroups(DocumentBuilder& builder, const Matrix& matrix, const LayerTable& layers, const StepData& step) {
    const EdaData& eda = step.eda.value;
    const std::vector<std::size_t> rows = matrixRows(matrix, eda);
    for (const EdaGroup& from : eda.groups) {
        std::vector<ElementId> elements;
        for (std::uint32_t i = from.firstFeature; i < from.firstFeature + from.featureCount; ++i) {
            const std::size_t row = rows[eda.features[i].layer];
            if (row == matrix.layers.size() ||
                eda.features[i].feature >= step.layers[row].features.value.features.size()) {
                builder.diagnostics().report(Severity::Warning, step.eda.path, eda.features[i].line,
                                             "FID: a group names a feature that is not there");
                continue;
            }
            const auto made = formats::elementsOf(builder.soFar(), layers.id(row), eda.features[i].feature);
            elements.insert(elements.end(), made.begin(), made.end());
        }
        std::ranges::sort(elements);
        elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
        ElementGroup group;
        group.type = builder.string(from.type);
        group.properties = addProperties(builder, from.properties);
        builder.addGroup(group, elements);
    }
}

}  // namespace model::odb
