#pragma once

#include <QOpenGLWidget>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class QSurface;
class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;
class vtkObject;
class vtkRenderer;

namespace kumite::studio {

/// A Qt widget that shows one VTK renderer: VTK draws into its own framebuffer inside Qt's
/// context, the picture is copied into the widget's framebuffer. Draws only what was marked
/// dirty. Mouse and keys are left to the parent widget. Survives a change of its OpenGL context.
class VtkWidget : public QOpenGLWidget {
    Q_OBJECT

public:
    explicit VtkWidget(QWidget* parent = nullptr);
    ~VtkWidget() override;

    vtkRenderer* renderer() const;
    /// Whether pictures are computed without a graphics card; known once something was drawn.
    bool isSoftware() const { return software_; }
    /// The scene changed: draw it anew at the next occasion.
    void markDirty();

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;

private:
    static void handleWindowEvent(vtkObject* caller, unsigned long event, void* self, void* data);
    void releaseContext();
    void copyPicture();

    vtkNew<vtkGenericOpenGLRenderWindow> window_;
    vtkNew<vtkRenderer> renderer_;
    vtkNew<vtkCallbackCommand> observer_;
    QSurface* surface_ = nullptr;  ///< the one that Qt makes current with our context
    bool ready_ = false;
    bool dirty_ = true;
    bool software_ = false;
};

}  // namespace kumite::studio
