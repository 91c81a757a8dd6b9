#include "ui/stackup/name_cut.h"

#include <QSet>
#include <algorithm>

namespace ui {

namespace {

QString commonPrefix(const QStringList& names) {
    QString prefix = names.size() < 2 ? QString() : names.front();
    for (const QString& name : names) {
        const auto [own, other] = std::mismatch(prefix.begin(), prefix.end(), name.begin(), name.end());
        prefix.truncate(own - prefix.begin());
    }
    return prefix;
}

}  // namespace

NameCut NameCut::forAll(const QStringList& names, const QFontMetrics& metrics, int width) {
    const QString prefix = commonPrefix(names);
    NameCut best({}, Qt::ElideMiddle);
    qsizetype most = 0;
    for (const NameCut& cut : {NameCut({}, Qt::ElideMiddle), NameCut({}, Qt::ElideLeft), NameCut({}, Qt::ElideRight),
                               NameCut(prefix, Qt::ElideMiddle), NameCut(prefix, Qt::ElideRight)}) {
        QSet<QString> different;
        for (const QString& name : names) {
            different.insert(cut.of(name, metrics, width));
        }
        if (different.size() > most) {
            most = different.size();
            best = cut;
        }
    }
    return best;
}

QString NameCut::of(const QString& name, const QFontMetrics& metrics, int width) const {
    const bool fits = metrics.horizontalAdvance(name) <= width;
    const bool isShortened = !fits && !m_prefix.isEmpty() && name.startsWith(m_prefix);
    return metrics.elidedText(isShortened ? QChar(0x2026) + name.mid(m_prefix.size()) : name, m_mode, width);
}

}  // namespace ui
