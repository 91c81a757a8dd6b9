#pragma once

#include <QFontMetrics>
#include <QString>
#include <QStringList>

namespace ui {

/// How names that do not fit are cut, all in one way, so that what differs is kept: "…TopSilkLa…" and "…TopPasteM…" of
/// names that all begin with "Gerber_".
class NameCut {
public:
    /// In the middle, unless fewer of the names come out alike another way.
    [[nodiscard]] static NameCut forAll(const QStringList& names, const QFontMetrics& metrics, int width);
    /// A name as it fits.
    [[nodiscard]] QString of(const QString& name, const QFontMetrics& metrics, int width) const;

private:
    NameCut(QString prefix, Qt::TextElideMode mode) : m_prefix(std::move(prefix)), m_mode(mode) {}

    QString m_prefix;  ///< left out first
    Qt::TextElideMode m_mode;
};

}  // namespace ui
