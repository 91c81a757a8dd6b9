#include "ui/nets/net_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>
#include <map>

#include "ui/common/net_name.h"

namespace ui {

namespace {

/// Lengths per layer are measured on demand; with more elements than this that is too slow.
constexpr std::size_t kMostMeasured = 200'000;

std::size_t elementsOf(const model::Document& document, std::span<const model::NetId> nets) {
    std::size_t count = 0;
    for (const model::NetId net : nets) {
        count += document.elementsOf(net).size();
    }
    return count;
}

struct NetText {
    Q_DECLARE_TR_FUNCTIONS(ui::NetText)
};

QString counted(std::uint64_t count, const QString& one, const QString& many) {
    return count == 1 ? one : many.arg(count);
}

QString totalsText(const model::NetStatistics& statistics, std::span<const model::NetId> nets, LengthUnit unit) {
    std::uint64_t pins = 0;
    std::uint64_t vias = 0;
    double length = 0.0;
    for (const model::NetId net : nets) {
        pins += statistics.pins[net.row()];
        vias += statistics.vias[net.row()];
        length += statistics.lengthNm[net.row()];
    }
    return QStringList{counted(pins, NetText::tr("1 pin"), NetText::tr("%L1 pins")),
                       counted(vias, NetText::tr("1 via"), NetText::tr("%L1 vias")),
                       NetText::tr("%1 routed").arg(lengthInBoth(length, unit))}
        .join(QStringLiteral(" · "));
}

/// Of what is shown of the two: lengths that the table shows as two differ here, too.
QString differenceText(double one, double other, LengthUnit unit) {
    const auto shown = [unit](double length) {
        return fixedLengthText(length, unit).section(QLatin1Char(' '), 0, 0).toDouble() * nmPer(unit);
    };
    return NetText::tr("Their lengths differ by %1").arg(fixedLengthInBoth(std::abs(shown(one) - shown(other)), unit));
}

QString layersText(const model::Document& document, std::span<const model::NetId> nets, LengthUnit unit) {
    std::map<model::LayerId, double> lengths;
    for (const model::NetId net : nets) {
        for (const auto& [layer, length] : model::routedLengths(document, net)) {
            lengths[layer] += length;
        }
    }
    QStringList texts;
    for (const auto& [layer, length] : lengths) {
        texts +=
            QStringLiteral("%1: %2").arg(QString::fromStdString(document.layer(layer).name), lengthText(length, unit));
    }
    return texts.isEmpty() ? QString() : '\n' + texts.join(QStringLiteral(" · "));
}

}  // namespace

QString netsText(const model::Document& document, const model::NetStatistics* statistics,
                 std::span<const model::NetId> nets, LengthUnit unit) {
    if (nets.empty()) {
        return {};
    }
    QString text = nets.size() == 1 ? netName(document, nets.front()) : NetText::tr("%L1 nets").arg(nets.size());
    if (statistics != nullptr) {
        text += '\n' + totalsText(*statistics, nets, unit);
        if (nets.size() == 2) {
            text +=
                '\n' + differenceText(statistics->lengthNm[nets[0].row()], statistics->lengthNm[nets[1].row()], unit);
        }
    }
    return elementsOf(document, nets) <= kMostMeasured ? text + layersText(document, nets, unit) : text;
}

}  // namespace ui
