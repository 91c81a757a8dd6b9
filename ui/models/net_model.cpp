#include "ui/models/net_model.h"

#include <QRegularExpression>
#include <algorithm>
#include <numeric>

namespace ui::models {

namespace {

struct ColumnText {
    const char* heading;
    const char* tip;
};

constexpr ColumnText kColumns[NetModel::ColumnCount] = {
    {"Net", "Name in the job"},
    {"Pins", "Pins of components on the net"},
    {"Holes", "Plated holes: vias, and pins that go through the board"},
    {"Length", "Middle lines of all strokes on copper layers, pads left out"},
    {"Copper", "Area of what is drawn on copper layers; where elements overlap it counts twice"},
};

constexpr std::size_t kCheckEvery = 4096;  // nets between two looks at whether the answer is still wanted

/// Decides on names; made once per filter.
class Filter {
public:
    Filter(const QString& pattern, NetModel::FilterKind kind) {
        if (kind == NetModel::FilterKind::Text) {
            for (const QString& word : pattern.toLower().split(' ', Qt::SkipEmptyParts)) {
                m_words.push_back(word.toStdString());
            }
            return;
        }
        const QString text =
            kind == NetModel::FilterKind::Wildcard ? QRegularExpression::wildcardToRegularExpression(pattern) : pattern;
        if (!pattern.isEmpty()) {
            m_expression.emplace(text, QRegularExpression::CaseInsensitiveOption);
        }
    }

    [[nodiscard]] bool isValid() const { return !m_expression || m_expression->isValid(); }
    [[nodiscard]] bool takes(const std::string& name) const {
        if (m_expression) {
            return m_expression->match(QString::fromStdString(name)).hasMatch();
        }
        return std::ranges::all_of(m_words, [&](const std::string& word) { return contains(name, word); });
    }

private:
    static bool contains(const std::string& name, const std::string& word) {
        const auto same = [](char a, char b) {
            return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + ('a' - 'A')) : a) == b;
        };
        return std::search(name.begin(), name.end(), word.begin(), word.end(), same) != name.end();
    }

    std::vector<std::string> m_words;
    std::optional<QRegularExpression> m_expression;
};

QString withThousands(qulonglong value) {
    return QStringLiteral("%L1").arg(value);
}

}  // namespace

/// What is worked out in the background, from frozen tables alone.
struct NetModel::Task {
    std::shared_ptr<const model::Document> document;
    std::shared_ptr<const model::NetStatistics> statistics;
    Filter filter;
    int column = Name;
    Qt::SortOrder order = Qt::AscendingOrder;

    /// What rows are ordered by; equal ones by name.
    [[nodiscard]] double keyOf(std::uint32_t net) const {
        switch (column) {
            case Pins: return statistics->pins[net];
            case Holes: return statistics->holes[net];
            case Length: return statistics->lengthNm[net];
            case Area: return statistics->areaNm2[net];
            default: return statistics->nameRank[net];
        }
    }

    template <class IsWanted>
    [[nodiscard]] Rows run(const IsWanted& isWanted) const {
        Rows rows;
        for (std::uint32_t net = 0; net < document->nets.size(); ++net) {
            if (net % kCheckEvery == 0 && !isWanted()) {
                return {};
            }
            if (filter.takes(document->nets[net].name)) {
                rows.push_back(net);
            }
        }
        if (statistics) {
            sort(rows);
        }
        return rows;
    }

    void sort(Rows& rows) const {
        std::ranges::sort(rows, [&](std::uint32_t a, std::uint32_t b) {
            const double ka = keyOf(a);
            const double kb = keyOf(b);
            if (ka != kb) {
                return order == Qt::AscendingOrder ? ka < kb : ka > kb;
            }
            return statistics->nameRank[a] < statistics->nameRank[b];
        });
    }
};

NetModel::NetModel(QObject* parent) : QAbstractTableModel(parent) {
    m_pool.setMaxThreadCount(1);
}

NetModel::~NetModel() {
    ++m_wanted;  // ends what is being worked out
    m_pool.clear();
    m_pool.waitForDone();
}

void NetModel::setNets(std::shared_ptr<const model::Document> document,
                       std::shared_ptr<const model::NetStatistics> statistics) {
    beginResetModel();
    m_document = std::move(document);
    m_statistics = std::move(statistics);
    m_rows.clear();
    endResetModel();
    arrange();
}

void NetModel::setUnit(LengthUnit unit) {
    m_unit = unit;
    if (!m_rows.empty()) {
        emit dataChanged(index(0, Length), index(rowCount() - 1, Area));
    }
}

bool NetModel::setFilter(const QString& pattern, FilterKind kind) {
    const bool isValid = Filter(pattern, kind).isValid();
    m_pattern = isValid ? pattern : QString();
    m_kind = kind;
    arrange();
    return isValid;
}

void NetModel::sort(int column, Qt::SortOrder order) {
    m_column = column;
    m_order = order;
    arrange();
}

void NetModel::arrange() {
    const std::uint64_t number = ++m_wanted;
    if (!m_document) {
        take({}, number);
        return;
    }
    m_pool.clear();  // what has not begun is not wanted any more
    m_pool.start([this, number, task = Task{m_document, m_statistics, Filter(m_pattern, m_kind), m_column, m_order}] {
        const auto isWanted = [&] { return m_wanted == number; };
        Rows rows = task.run(isWanted);
        if (isWanted()) {
            QMetaObject::invokeMethod(
                this, [this, number, rows = std::move(rows)]() mutable { take(std::move(rows), number); },
                Qt::QueuedConnection);
        }
    });
}

void NetModel::take(Rows rows, std::uint64_t number) {
    if (number != m_wanted) {
        return;
    }
    beginResetModel();
    m_rows = std::move(rows);
    m_shown = number;
    endResetModel();
    emit arranged();
}

std::optional<int> NetModel::rowOf(model::NetId net) const {
    const auto found = std::ranges::find(m_rows, net.value);
    return found == m_rows.end() ? std::nullopt : std::optional(static_cast<int>(found - m_rows.begin()));
}

int NetModel::total() const {
    return m_document ? static_cast<int>(m_document->nets.size()) : 0;
}

int NetModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int NetModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant NetModel::number(std::size_t net, int column) const {
    if (!m_statistics) {
        return 0;
    }
    switch (column) {
        case Pins: return m_statistics->pins[net];
        case Holes: return m_statistics->holes[net];
        case Length: return m_statistics->lengthNm[net] / nmPer(m_unit);
        default: return m_statistics->areaNm2[net] / (base::kNmPerMm * base::kNmPerMm);
    }
}

QString NetModel::text(std::size_t net, int column) const {
    if (!m_statistics) {
        return {};
    }
    switch (column) {
        case Pins: return withThousands(m_statistics->pins[net]);
        case Holes: return withThousands(m_statistics->holes[net]);
        case Length: return lengthText(m_statistics->lengthNm[net], m_unit);
        default: return areaText(m_statistics->areaNm2[net], m_unit);
    }
}

QString NetModel::tip(model::NetId net) const {
    QString tip = QString::fromStdString(m_document->nets[net.row()].name);
    for (const auto& [layer, length] : model::routedLengths(*m_document, net)) {
        tip += QStringLiteral("\n%1: %2")
                   .arg(QString::fromStdString(m_document->layer(layer).name), lengthInBoth(length, m_unit));
    }
    return tip;
}

QVariant NetModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const model::NetId net = netAt(index.row());
    const bool isName = index.column() == Name;
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
            if (isName) {
                return QString::fromStdString(m_document->nets[net.row()].name);
            }
            return role == Qt::EditRole ? number(net.row(), index.column()) : text(net.row(), index.column());
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(Qt::Alignment(Qt::AlignVCenter | (isName ? Qt::AlignLeft : Qt::AlignRight)));
        case Qt::ToolTipRole: return tip(net);
        default: return {};
    }
}

QVariant NetModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole: return kColumns[section].heading;
        case Qt::ToolTipRole: return kColumns[section].tip;
        default: return {};
    }
}

}  // namespace ui::models
