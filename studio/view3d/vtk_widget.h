#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <vector>

#include <vtkNew.h>

class QOffscreenSurface;
class QOpenGLContext;
class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;
class vtkObject;
class vtkRenderer;

namespace kumite::studio {

/// A Qt widget that shows one VTK renderer. VTK draws into a framebuffer of a context of its own;
/// the picture is read back and painted like any other. An OpenGL widget would make Qt compose the
/// whole window anew for each change anywhere in it, which without a graphics card takes longer
/// than the scene. Draws only what was marked dirty. Mouse and keys are left to the parent widget.
///
/// Without a graphics card edges are smoothed only once the picture has stood still for a moment.
/// While the widget is being resized the picture that is there is stretched; the new one follows.
class VtkWidget : public QWidget {
    Q_OBJECT

public:
    explicit VtkWidget(QWidget* parent = nullptr);
    ~VtkWidget() override;

    vtkRenderer* renderer() const;
    /// Draws this one, too: a part of the picture by its viewport.
    void add(vtkRenderer* renderer);
    /// The scene changed: draw it anew at the next occasion.
    void markDirty();
    /// The picture with smooth edges, device pixels.
    QImage picture();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    static void handleWindowEvent(vtkObject* caller, unsigned long event, void* self, void* data);
    bool start();
    void draw(bool smooth);
    void readPicture();
    void smoothen();

    std::unique_ptr<QOffscreenSurface> surface_;
    std::unique_ptr<QOpenGLContext> context_;
    vtkNew<vtkGenericOpenGLRenderWindow> window_;
    vtkNew<vtkRenderer> renderer_;
    vtkNew<vtkCallbackCommand> observer_;
    std::vector<quint32> pixels_;  ///< as OpenGL gives them: the lowest row first
    QImage picture_;
    QTimer stillness_;
    QTimer resized_;  ///< until the picture in the new size is drawn
    bool ready_ = false;
    bool dirty_ = true;
    bool smooth_ = false;    ///< picture_ has smooth edges
    bool software_ = false;  ///< pictures are computed without a graphics card
};

}  // namespace kumite::studio
