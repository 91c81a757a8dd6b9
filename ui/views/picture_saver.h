#pragma once

#include <QObject>
#include <QTimer>
#include <deque>
#include <future>
#include <memory>

#include "ui/canvas/view_picture.h"
#include "ui/workspace/background_result.h"

namespace ui {

class BoardView;
class BoardViews;
struct FeatureContext;
class Workspace;

/// Saves and copies pictures of views while the window goes on: the device draws them in its turn, a thread of their
/// own paints what is over the board and packs the pixels. One after the other, each as the view was when it was asked
/// for; the workspace shows how far the first is, lets Esc stop it, and asks before the window is closed over one that
/// is saved. They go on while another board is read; once it is there, those that the device has not begun are reported
/// as not saved.
class PictureSaver : public QObject {
    Q_OBJECT

public:
    explicit PictureSaver(FeatureContext& context);
    ~PictureSaver() override;

    /// Writes a PNG, all of it or nothing, `width` pixels wide (0: as on the screen), and reports what came of it. A
    /// size that the device cannot draw is reported at once.
    void save(const BoardView& view, const QString& path, int width = 0);
    /// To the clipboard.
    void copy(const BoardView& view);

private:
    struct Wanted {
        ViewShot shot;
        QString path;  ///< empty: the clipboard
    };
    /// What the window and the thread share.
    struct Job;

    void add(const BoardView& view, double scale, const QString& path);
    void start(Wanted wanted);
    void look();
    void takeTurn();
    void make();
    void begin();
    [[nodiscard]] bool isBoardThere() const;
    void end(const base::Status& drawn);
    void goOn();
    void report();
    /// The name of the file that is written, or of the first that waits while a picture is copied; empty: no file.
    [[nodiscard]] QString nextFile() const;
    /// Those that wait, and the current one, too; reports them.
    void giveUp(bool hasCurrent, const QString& why);
    void releaseDevice();

    GpuContext& m_context;
    BoardViews& m_views;
    Workspace& m_workspace;
    BackgroundResult<QImage> m_work;
    std::deque<Wanted> m_waiting;
    std::shared_ptr<Job> m_job;  ///< what is drawn and written now
    QString m_path;              ///< of it
    QTimer m_look;               ///< runs until the device is done: is it?
    bool m_isMaking = false;     ///< the thread makes what the current one lacks, or has made it
    bool m_isBegun = false;      ///< the device has been given the current one, which needs its board no more
    bool m_isDrawing = false;    ///< the device is, maybe for a picture that is no longer wanted
};

}  // namespace ui
