#include "compare/report/egl_window.h"

#include <dlfcn.h>
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkAutoInit.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include "base/errors.h"

/// VTK calls glewInit, which loads all entry points and then fails for want of a GLX display (4,
/// GLEW_ERROR_NO_GLX_DISPLAY). Under EGL that is no fault. The linker exports this name because VTK's shared library
/// refers to it.
extern "C" unsigned int glewInit() {
    using Function = unsigned int (*)();
    const auto real = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glewInit"));
    const unsigned int status = real ? real() : 1;
    return status == 4 ? 0 : status;
}

// VTK's makers of OpenGL objects. Not vtk_module_autoinit: it would name this checkout in the command of every file.
VTK_MODULE_INIT(vtkRenderingOpenGL2)

namespace tw {

namespace {

class Window : public vtkGenericOpenGLRenderWindow {
public:
    static Window* New();
    vtkTypeMacro(Window, vtkGenericOpenGLRenderWindow);
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    void MakeCurrent() override { eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context); }
    bool IsCurrent() override { return eglGetCurrentContext() == context; }
    int SupportsOpenGL() override { return 1; }
    vtkTypeBool IsDirect() override { return 1; }
};
vtkStandardNewMacro(Window);

/// One display for the whole process, opened when first needed and kept: Mesa's software driver loses a little memory
/// each time a display is terminated, and starting it again costs more than drawing.
EGLDisplay surfaceless_display() {
    static const EGLDisplay display = [] {
        const auto platform_display =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        if (!platform_display) throw RunError("no pictures: this EGL knows no surfaceless display");
        const EGLDisplay found = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (found == EGL_NO_DISPLAY || !eglInitialize(found, nullptr, nullptr))
            throw RunError("no pictures: no surfaceless EGL display (packages libegl1, libegl-mesa0, libgl1-mesa-dri)");
        return found;
    }();
    return display;
}

}  // namespace

struct EglWindow::Impl {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    vtkSmartPointer<Window> window;

    ~Impl() {
        if (window) {
            window->MakeCurrent();
            window->Finalize();
            window = nullptr;
        }
        if (context != EGL_NO_CONTEXT) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(display, context);
        }
    }
};

EglWindow::EglWindow(int width, int height) : impl_(std::make_unique<Impl>()) {
    impl_->display = surfaceless_display();
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config{};
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(impl_->display, wanted, &config, 1, &count) || count < 1)
        throw RunError("no pictures: EGL offers no OpenGL here");
    const EGLint version[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    impl_->context = eglCreateContext(impl_->display, config, EGL_NO_CONTEXT, version);
    if (impl_->context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl_->context))
        throw RunError("no pictures: no OpenGL 3.2 context without a surface");

    impl_->window = vtkSmartPointer<Window>::New();
    impl_->window->display = impl_->display;
    impl_->window->context = impl_->context;
    impl_->window->SetOffScreenRendering(1);
    impl_->window->SetShowWindow(false);
    impl_->window->SetReadyForRendering(true);
    impl_->window->SetFrameBlitModeToNoBlit();
    impl_->window->SetSize(width, height);
    impl_->window->SetMultiSamples(4);
    impl_->window->OpenGLInit();
}

EglWindow::~EglWindow() = default;

std::string EglWindow::png(vtkRenderer* renderer) {
    impl_->window->AddRenderer(renderer);
    impl_->window->Render();
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(impl_->window);
    grab->SetInputBufferTypeToRGB();
    grab->ReadFrontBufferOff();
    grab->ShouldRerenderOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grab->GetOutputPort());
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    std::string out(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                    static_cast<std::size_t>(bytes->GetNumberOfValues()));
    impl_->window->RemoveRenderer(renderer);
    return out;
}

}  // namespace tw
