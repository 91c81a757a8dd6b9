#pragma once

#include <QDialog>
#include <QVariant>
#include <optional>
#include <vector>

#include "model/export/files/export_file.h"
#include "ui/workspace/settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace ui {

class ExportLayers;
class ExportNets;
class ExportPath;
class LayerModel;

/// What the window shows when something is to be exported.
struct ExportSource {
    QString name;    ///< of the board, without an ending
    QString folder;  ///< that is proposed before the first export
    const LayerModel& layers;
    std::vector<std::string> nets;          ///< names of all
    std::vector<std::string> selectedNets;  ///< names of those of the selection
    std::optional<base::Box> window;        ///< what the 2D view shows, nm of the board; none while it is hidden
    LengthUnit unit;
};

/// What of a board is exported, as what, and where to: the choices of `copperscope export`. Those that the format does
/// not know are disabled, do not count and show nothing that is not done; they come back with a format that knows them.
/// It begins with what was exported the last time, and asks before it replaces a file. `layers` must live longer.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    ExportDialog(const ExportSource& source, Settings& settings, QWidget* parent = nullptr);

    /// Instead of the format of the last time.
    void choose(const model::ExportFormat& format);
    [[nodiscard]] const model::ExportFormat& format() const;
    /// Without colours and time.
    [[nodiscard]] model::ExportRequest request() const;
    [[nodiscard]] QString path() const;
    /// Is there nothing that keeps it from being exported?
    [[nodiscard]] bool isReady() const { return problem().isEmpty(); }
    /// About how large the file will be, in words.
    void setEstimate(const QString& text);
    void accept() override;

signals:
    /// What is exported is another.
    void changed();
    /// A picture of the view is wanted instead.
    void pictureWanted();

private:
    /// What some formats know.
    struct Choice {
        QWidget* widget;
        const char* property;  ///< of the widget: what is chosen
        QVariant none;         ///< what the widget shows while it does not apply
        bool model::ExportFormat::*isKnown;
        QVariant chosen{};  ///< meanwhile
    };

    QWidget* target(const ExportSource& source);
    QWidget* contents();
    QWidget* answers();
    void restore();
    void remember();
    void onFormat();
    void listChoices();
    /// Of a widget of a choice, also while that does not apply.
    [[nodiscard]] QVariant chosen(const QWidget* widget) const;
    void showProblem();
    [[nodiscard]] QString problem() const;

    Settings& m_settings;
    std::optional<base::Box> m_window;
    double m_nmPerUnit;
    QComboBox* m_format;
    ExportPath* m_path;
    ExportLayers* m_layers;
    ExportNets* m_nets;
    QComboBox* m_area;
    QDoubleSpinBox* m_minHole;
    std::vector<QCheckBox*> m_options;  ///< rows of the table of options
    std::vector<Choice> m_choices;      ///< these options among them
    QLabel* m_estimate;
    QLabel* m_problem;
    QPushButton* m_export = nullptr;
};

}  // namespace ui
