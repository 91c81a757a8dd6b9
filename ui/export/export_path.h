#pragma once

#include <QWidget>

#include "model/export/files/export_file.h"

class QLineEdit;

namespace ui {

/// The file that is written, in a line and by a dialog. Its ending follows the format, and the format the ending that
/// is typed.
class ExportPath : public QWidget {
    Q_OBJECT

public:
    /// Proposed is this name, which has no ending, in the folder.
    ExportPath(QString folder, const QString& name, QWidget* parent = nullptr);

    void setFormat(const model::ExportFormat& format);
    /// Absolute, with an ending of the format; empty where nothing is typed.
    [[nodiscard]] QString path() const;
    /// Why nothing can be written there; empty: nothing is known against it.
    [[nodiscard]] QString problem() const;

signals:
    void changed();
    void formatTyped(const model::ExportFormat& format);

private:
    void browse();
    void take(const QString& path);

    QString m_folder;  ///< where a name without a folder is meant to be
    const model::ExportFormat* m_format;
    QLineEdit* m_line;
};

}  // namespace ui
