#include "studio/view3d/vtk_widget.h"

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFunctions>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace kumite::studio {

VtkWidget::VtkWidget(QWidget* parent) : QOpenGLWidget(parent) {
    window_->SetMultiSamples(0);
    window_->SetOwnContext(0);
    window_->SetFrameBlitModeToNoBlit();
    window_->SetReadyForRendering(false);
    window_->SetSupportsOpenGL(1);
    window_->SetIsDirect(1);
    window_->AddRenderer(renderer_);
    observer_->SetClientData(this);
    observer_->SetCallback(&VtkWidget::handleWindowEvent);
    window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, observer_);
    window_->AddObserver(vtkCommand::WindowIsCurrentEvent, observer_);
}

VtkWidget::~VtkWidget() {
    if (QOpenGLContext* mine = context()) {
        disconnect(mine, &QOpenGLContext::aboutToBeDestroyed, this, nullptr);
        releaseContext();
    }
    window_->RemoveObserver(observer_);
    window_->RemoveRenderer(renderer_);
}

vtkRenderer* VtkWidget::renderer() const {
    return renderer_;
}

void VtkWidget::markDirty() {
    dirty_ = true;
    update();
}

void VtkWidget::handleWindowEvent(vtkObject*, unsigned long event, void* self, void* data) {
    auto* widget = static_cast<VtkWidget*>(self);
    QOpenGLContext* mine = widget->context();
    if (event == vtkCommand::WindowMakeCurrentEvent) {
        // Not QOpenGLWidget::makeCurrent: that rebinds Qt's framebuffer behind VTK's cached state.
        if (mine != nullptr && widget->surface_ != nullptr) mine->makeCurrent(widget->surface_);
    } else if (event == vtkCommand::WindowIsCurrentEvent) {
        *static_cast<bool*>(data) = mine != nullptr && mine == QOpenGLContext::currentContext();
    }
}

void VtkWidget::initializeGL() {
    QOpenGLContext* mine = context();
    surface_ = mine->surface();
    connect(mine, &QOpenGLContext::aboutToBeDestroyed, this, &VtkWidget::releaseContext,
            Qt::UniqueConnection);
    window_->SetForceMaximumHardwareLineWidth(1);
    window_->SetReadyForRendering(true);
    window_->OpenGLInitContext();
    window_->SetMapped(1);
    const auto* name = mine->functions()->glGetString(GL_RENDERER);
    const QByteArray device(reinterpret_cast<const char*>(name));
    software_ = device.contains("llvmpipe") || device.contains("softpipe") ||
                device.contains("SWR") || device.contains("Software");
    ready_ = true;
    dirty_ = true;
}

void VtkWidget::releaseContext() {
    if (!ready_) return;
    ready_ = false;
    makeCurrent();
    window_->Finalize();
    window_->SetReadyForRendering(false);
    doneCurrent();
    surface_ = nullptr;
}

void VtkWidget::resizeGL(int width, int height) {
    const double ratio = devicePixelRatioF();
    window_->SetSize(std::max(1, static_cast<int>(std::lround(width * ratio))),
                     std::max(1, static_cast<int>(std::lround(height * ratio))));
    dirty_ = true;
}

void VtkWidget::paintGL() {
    if (!ready_) return;
    if (dirty_) {
        dirty_ = false;
        vtkOpenGLState* state = window_->GetState();
        state->Reset();
        state->Push();
        state->vtkglDepthFunc(GL_LEQUAL);
        window_->Render();
        state->Pop();
    }
    copyPicture();
}

void VtkWidget::copyPicture() {
    vtkOpenGLFramebufferObject* picture = window_->GetDisplayFramebuffer();
    QOpenGLExtraFunctions* gl = context()->extraFunctions();
    const int* size = window_->GetSize();
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, picture->GetFBOIndex());
    gl->glReadBuffer(GL_COLOR_ATTACHMENT0);
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    gl->glDisable(GL_SCISSOR_TEST);
    gl->glBlitFramebuffer(0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    // Anything but opaque would show what lies behind the widget, and leave holes in grabs.
    gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl->glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace kumite::studio
