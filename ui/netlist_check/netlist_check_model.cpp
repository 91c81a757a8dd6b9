#include "ui/netlist_check/netlist_check_model.h"

#include <QColor>
#include <algorithm>

#include "model/nets/net_inference.h"
#include "ui/common/net_name.h"

namespace ui {

namespace {

/// In the order of FindingKind; mid tones, readable on a light and on a dark ground; the word says the same.
constexpr QColor kKindColours[] = {
    {0xd9, 0x4a, 0x3d}, {0xe0, 0x9a, 0x1f}, {0xe0, 0x9a, 0x1f}, {0x56, 0x8c, 0xc8}, {0x80, 0x80, 0x80}};

/// "1 short", "2 shorts", "no shorts"
QString counted(qsizetype count, const QString& none, const QString& one, const QString& many) {
    return count == 0 ? none : count == 1 ? one : many.arg(count);
}

/// Why there is nothing that copper could differ from; empty if there is.
QString whyNotCompared(const std::vector<model::StepCheck>& checks) {
    const auto hasNets = [](const model::StepCheck& check) { return !check.step->nets.empty(); };
    const auto isOfCopper = [](const model::StepCheck& check) { return model::areNetsOfCopper(*check.step); };
    if (std::ranges::none_of(checks, hasNets)) {
        return NetlistCheckModel::tr("nothing to compare: there are no nets");
    }
    return std::ranges::count_if(checks, hasNets) == std::ranges::count_if(checks, isOfCopper)
               ? NetlistCheckModel::tr("nothing to compare: the nets follow from the copper")
               : QString();
}

}  // namespace

NetlistCheckModel::NetlistCheckModel(QObject* parent)
    : TableModel({{tr("Kind"), tr("Short: copper of two nets touches. Open: a net is in several parts. No net: a pin "
                                  "without a net touches copper of one. Floating: copper that leads nowhere. Tie: a "
                                  "component joins two nets on purpose")},
                  {tr("Net"), tr("The nets concerned")},
                  {tr("What"), tr("What was found there")},
                  {tr("Layer"), tr("Where it is")},
                  {tr("X"), tr("Where it is, in the coordinates of the step"), kNumber},
                  {tr("Y"), tr("Where it is, in the coordinates of the step"), kNumber},
                  {tr("Step"), tr("The step it is on; seen in all its copies")}},
                 parent) {}

void NetlistCheckModel::setChecks(std::shared_ptr<const model::Document> board, std::vector<model::StepCheck> checks) {
    beginResetModel();
    m_board = std::move(board);
    m_checks = std::move(checks);
    m_findings.clear();
    for (std::uint32_t step = 0; step < m_checks.size(); ++step) {
        listStep(step);
    }
    std::ranges::stable_sort(m_findings, {}, &Finding::kind);
    endResetModel();
}

void NetlistCheckModel::listStep(std::uint32_t step) {
    const model::NetReport& report = m_checks[step].report;
    for (std::uint32_t row = 0; row < report.shorts.size(); ++row) {
        m_findings.push_back({FindingKind::Short, step, row, report.shorts[row].a});
    }
    for (std::uint32_t row = 0; row < report.pinsOnNets.size(); ++row) {
        m_findings.push_back({FindingKind::NoNet, step, row, report.pinsOnNets[row].net});
    }
    for (std::uint32_t row = 0; row < report.ties.size(); ++row) {
        m_findings.push_back({FindingKind::Tie, step, row, report.ties[row].netA});
    }
    for (const model::OpenNet& open : report.opens) {
        const bool isOpen = model::hasSeveralPadIslands(report, open);
        for (std::uint32_t at = 0; at < open.islandCount; ++at) {
            const bool hasPads = report.islands[open.firstIsland + at].padCount > 0;
            if (isOpen || (!hasPads && at > 0)) {  // of a net that is whole, the largest island is the net
                const FindingKind kind = hasPads ? FindingKind::Open : FindingKind::Floating;
                m_findings.push_back({kind, step, open.firstIsland + at, open.net});
            }
        }
    }
}

std::vector<model::ElementId> NetlistCheckModel::elementsOf(const Finding& finding) const {
    if (finding.kind == FindingKind::NoNet) {
        return {pinOnNet(finding).pad, pinOnNet(finding).copper};
    }
    if (finding.kind != FindingKind::Short) {
        return {finding.kind == FindingKind::Tie ? tie(finding).element : island(finding).element};
    }
    const model::ShortedNets& entry = shorted(finding);
    std::vector<model::ElementId> elements{entry.elementA, entry.elementB};
    if (entry.through.isValid()) {
        elements.push_back(entry.through);
    }
    return elements;
}

model::PointD NetlistCheckModel::locationOf(const Finding& finding) const {
    return finding.kind == FindingKind::Short   ? shorted(finding).location
           : finding.kind == FindingKind::NoNet ? pinOnNet(finding).location
           : finding.kind == FindingKind::Tie   ? tie(finding).location
                                                : island(finding).location;
}

model::LayerId NetlistCheckModel::layerOf(const Finding& finding) const {
    return finding.kind == FindingKind::Short   ? shorted(finding).layer
           : finding.kind == FindingKind::NoNet ? pinOnNet(finding).layer
           : finding.kind == FindingKind::Tie   ? tie(finding).layer
                                                : island(finding).layer;
}

QString NetlistCheckModel::summary() const {
    if (!isChecked()) {
        return tr("Not checked yet");
    }
    qsizetype shorts = 0;
    qsizetype opens = 0;
    for (const model::StepCheck& check : m_checks) {
        shorts += static_cast<qsizetype>(check.report.shorts.size());
        opens += std::ranges::count_if(check.report.opens, [&](const model::OpenNet& open) {
            return model::hasSeveralPadIslands(check.report, open);
        });
    }
    const qsizetype floating = std::ranges::count(m_findings, FindingKind::Floating, &Finding::kind);
    const qsizetype pins = std::ranges::count(m_findings, FindingKind::NoNet, &Finding::kind);
    const qsizetype ties = std::ranges::count(m_findings, FindingKind::Tie, &Finding::kind);
    // A job may call its own nets as those that follow from copper: what differs is said.
    const QString why = shorts + opens == 0 ? whyNotCompared(m_checks) : QString();
    const QString faults =
        !why.isEmpty() ? why
                       : tr("%1, %2").arg(counted(shorts, tr("no shorts"), tr("1 short"), tr("%L1 shorts")),
                                          counted(opens, tr("no open nets"), tr("1 open net"), tr("%L1 open nets")));
    return tr("%1, %2%3%4")
        .arg(faults,
             counted(floating, tr("no floating copper"), tr("1 piece of floating copper"),
                     tr("%L1 pieces of floating copper")),
             counted(pins, QString(), tr(", 1 pin without a net that touches one"),
                     tr(", %L1 pins without a net that touch one")),
             counted(ties, QString(), tr(", 1 net tie"), tr(", %L1 net ties")));
}

QString NetlistCheckModel::netsText(const Finding& finding) const {
    const model::Document& step = *stepCheck(finding).step;
    const QString first = netName(step, finding.net);
    const auto both = [&](model::NetId second) { return QStringLiteral("%1, %2").arg(first, netName(step, second)); };
    return finding.kind == FindingKind::Short ? both(shorted(finding).b)
           : finding.kind == FindingKind::Tie ? both(tie(finding).netB)
                                              : first;
}

QString NetlistCheckModel::designator(const Finding& finding, model::ComponentId component) const {
    return QString::fromStdString(stepCheck(finding).step->components[component.row()].refdes);
}

QString NetlistCheckModel::whatText(const Finding& finding) const {
    if (finding.kind == FindingKind::Short) {
        const model::ShortedNets& entry = shorted(finding);
        if (entry.component.isValid()) {
            const QString refdes = designator(finding, entry.component);
            return entry.through.isValid() ? tr("Joined by copper without a net between pads of %1").arg(refdes)
                                           : tr("Touch at pads of %1").arg(refdes);
        }
        return entry.through.isValid() ? tr("Joined by copper without a net")
                                       : counted(entry.contactCount, tr("Touch nowhere"), tr("Touch in 1 location"),
                                                 tr("Touch in %L1 locations"));
    }
    if (finding.kind == FindingKind::NoNet) {
        return QString::fromStdString(model::textOf(*stepCheck(finding).step, pinOnNet(finding)));
    }
    if (finding.kind == FindingKind::Tie) {
        const QString refdes = designator(finding, tie(finding).component);
        return tie(finding).isAssumed ? tr("Joined by %1; assumed from its name and its copper").arg(refdes)
                                      : tr("Joined by %1 on purpose").arg(refdes);
    }
    const model::NetIsland& part = island(finding);
    const QString pieces = counted(part.pieceCount, tr("no pieces"), tr("1 piece"), tr("%L1 pieces"));
    return finding.kind == FindingKind::Floating
               ? tr("Copper without a pad: %1").arg(pieces)
               : tr("Part of the net: %1, %2")
                     .arg(pieces,
                          counted(part.padCount, tr("no pads or holes"), tr("1 pad or hole"), tr("%L1 pads or holes")));
}

Cell NetlistCheckModel::cell(int row, int column) const {
    const Finding& found = finding(row);
    const QString kinds[] = {tr("Short"), tr("Open"), tr("No net"), tr("Floating"), tr("Net tie")};
    switch (column) {
        case Kind:
            return {.text = kinds[static_cast<std::size_t>(found.kind)],
                    .colour = kKindColours[static_cast<std::size_t>(found.kind)]};
        case Nets: return {netsText(found)};
        case What: return {whatText(found)};
        case Layer: return layerOf(found).isValid() ? text(m_board->layer(layerOf(found)).name) : Cell{QString()};
        case X: return length(locationOf(found).x);
        case Y: return length(locationOf(found).y);
        default: return text(stepCheck(found).step->job.step);
    }
}

}  // namespace ui
