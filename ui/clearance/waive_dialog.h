#pragma once

#include <QDialog>

class QLineEdit;

namespace ui {

/// Why a location is waived, or several, and by whom: it cannot be accepted without both.
class WaiveDialog : public QDialog {
    Q_OBJECT

public:
    WaiveDialog(const QString& location, const QString& author, QWidget* parent = nullptr);

    [[nodiscard]] QString reason() const;
    [[nodiscard]] QString author() const;

private:
    QLineEdit* m_reason;
    QLineEdit* m_author;
};

}  // namespace ui
