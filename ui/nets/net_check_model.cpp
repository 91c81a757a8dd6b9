#include "ui/nets/net_check_model.h"

#include <QColor>
#include <algorithm>

namespace ui {

namespace {

struct ColumnText {
    const char* heading;
    const char* tip;
};

constexpr ColumnText kColumns[NetCheckModel::ColumnCount] = {
    {"Kind", "Short: copper of two nets touches. Open: a net is in several parts. Loose: copper that leads nowhere"},
    {"Net", "The nets concerned"},
    {"What", "What was found there"},
    {"Layer", "Where it is"},
    {"X", "Where it is, in the coordinates of the step"},
    {"Y", "Where it is, in the coordinates of the step"},
    {"Step", "The step it is on; seen in all its copies"},
};

constexpr const char* kKindNames[] = {"Short", "Open", "Loose"};
/// Mid tones, readable on a light and on a dark ground; the word says the same.
constexpr QColor kKindColours[] = {{0xd9, 0x4a, 0x3d}, {0xe0, 0x9a, 0x1f}, {0x56, 0x8c, 0xc8}};

/// "1 short", "2 shorts", "no shorts"
QString counted(qsizetype count, const char* one, const char* many) {
    return count == 0   ? QStringLiteral("no %1").arg(QLatin1String(many))
           : count == 1 ? QStringLiteral("1 %1").arg(QLatin1String(one))
                        : QStringLiteral("%L1 %2").arg(count).arg(QLatin1String(many));
}

QString nameOf(const model::Document& step, model::NetId net) {
    return QString::fromStdString(step.nets[net.row()].name);
}

bool isPlace(int column) {
    return column == NetCheckModel::X || column == NetCheckModel::Y;
}

}  // namespace

void NetCheckModel::setChecks(std::shared_ptr<const model::Document> board, std::vector<model::StepCheck> checks) {
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

void NetCheckModel::listStep(std::uint32_t step) {
    const model::NetReport& report = m_checks[step].report;
    for (std::uint32_t row = 0; row < report.shorts.size(); ++row) {
        m_findings.push_back({FindingKind::Short, step, row, report.shorts[row].a});
    }
    for (const model::OpenNet& open : report.opens) {
        const bool isOpen = model::hasSeveralPadIslands(report, open);
        for (std::uint32_t at = 0; at < open.islandCount; ++at) {
            const bool hasPads = report.islands[open.firstIsland + at].padCount > 0;
            if (isOpen || (!hasPads && at > 0)) {  // of a net that is whole, the largest island is the net
                const FindingKind kind = hasPads ? FindingKind::Open : FindingKind::Loose;
                m_findings.push_back({kind, step, open.firstIsland + at, open.net});
            }
        }
    }
}

void NetCheckModel::setUnit(LengthUnit unit) {
    m_unit = unit;
    if (!m_findings.empty()) {
        emit dataChanged(index(0, X), index(rowCount() - 1, Y));
    }
}

const model::ShortedNets& NetCheckModel::shorted(const Finding& finding) const {
    return check(finding).report.shorts[finding.row];
}

const model::NetIsland& NetCheckModel::island(const Finding& finding) const {
    return check(finding).report.islands[finding.row];
}

std::vector<model::ElementId> NetCheckModel::elementsOf(const Finding& finding) const {
    if (finding.kind != FindingKind::Short) {
        return {island(finding).element};
    }
    const model::ShortedNets& entry = shorted(finding);
    std::vector<model::ElementId> elements{entry.elementA, entry.elementB};
    if (entry.through.isValid()) {
        elements.push_back(entry.through);
    }
    return elements;
}

model::PointD NetCheckModel::locationOf(const Finding& finding) const {
    return finding.kind == FindingKind::Short ? shorted(finding).location : island(finding).location;
}

model::LayerId NetCheckModel::layerOf(const Finding& finding) const {
    return finding.kind == FindingKind::Short ? shorted(finding).layer : island(finding).layer;
}

QString NetCheckModel::summary() const {
    if (!isChecked()) {
        return QStringLiteral("Not checked yet");
    }
    qsizetype shorts = 0;
    qsizetype opens = 0;
    for (const model::StepCheck& check : m_checks) {
        shorts += static_cast<qsizetype>(check.report.shorts.size());
        opens += std::ranges::count_if(check.report.opens, [&](const model::OpenNet& open) {
            return model::hasSeveralPadIslands(check.report, open);
        });
    }
    const qsizetype loose = std::ranges::count(m_findings, FindingKind::Loose, &Finding::kind);
    return QStringLiteral("%1, %2, %3")
        .arg(counted(shorts, "short", "shorts"), counted(opens, "open net", "open nets"),
             counted(loose, "loose piece of copper", "loose pieces of copper"));
}

int NetCheckModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_findings.size());
}

int NetCheckModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString NetCheckModel::netsText(const Finding& finding) const {
    const model::Document& step = *check(finding).step;
    const QString first = nameOf(step, finding.net);
    return finding.kind == FindingKind::Short ? QStringLiteral("%1, %2").arg(first, nameOf(step, shorted(finding).b))
                                              : first;
}

QString NetCheckModel::whatText(const Finding& finding) const {
    if (finding.kind == FindingKind::Short) {
        const model::ShortedNets& entry = shorted(finding);
        return entry.through.isValid()
                   ? QStringLiteral("Joined by copper without a net")
                   : QStringLiteral("Touch in %1").arg(counted(entry.contactCount, "place", "places"));
    }
    const model::NetIsland& part = island(finding);
    const QString pieces = counted(part.pieceCount, "piece", "pieces");
    return finding.kind == FindingKind::Loose
               ? QStringLiteral("Copper without a pad: %1").arg(pieces)
               : QStringLiteral("Part of the net: %1, %2")
                     .arg(pieces, counted(part.padCount, "pad or hole", "pads or holes"));
}

QVariant NetCheckModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const Finding& found = finding(index.row());
    if (role == Qt::ForegroundRole && index.column() == Kind) {
        return kKindColours[static_cast<std::size_t>(found.kind)];
    }
    if (role == Qt::EditRole && isPlace(index.column())) {  // for sorting
        const model::PointD location = locationOf(found);
        return index.column() == X ? location.x : location.y;
    }
    if (role != Qt::DisplayRole && role != Qt::EditRole) {
        return {};
    }
    switch (index.column()) {
        case Kind: return QLatin1String(kKindNames[static_cast<std::size_t>(found.kind)]);
        case Nets: return netsText(found);
        case What: return whatText(found);
        case Layer: {
            const model::LayerId layer = layerOf(found);
            return layer.isValid() ? QString::fromStdString(m_board->layer(layer).name) : QString();
        }
        case X: return lengthText(locationOf(found).x, m_unit);
        case Y: return lengthText(locationOf(found).y, m_unit);
        case Step: return QString::fromStdString(check(found).step->job.step);
        default: return {};
    }
}

QVariant NetCheckModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole: return QLatin1String(kColumns[section].heading);
        case Qt::ToolTipRole: return QString::fromUtf8(kColumns[section].tip);
        default: return {};
    }
}

}  // namespace ui
