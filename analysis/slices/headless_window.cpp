// SPDX-License-Identifier: MIT
#include "analysis/slices/headless_window.h"

#include <EGL/eglext.h>
#include <vtkOpenGLState.h>

#include <algorithm>
#include <string>

#include "solver/core/errors.h"

namespace bake {
namespace {

void require(bool success, const char* what) {
  if (!success) throw RunError(std::string("cannot draw without a display: ") + what + " failed (is libegl-mesa0 installed?)");
}

}  // namespace

HeadlessWindow::HeadlessWindow() {
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  require(get_display != nullptr, "eglGetPlatformDisplayEXT");
  display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  EGLint major, minor, configurations = 0;
  require(display_ != EGL_NO_DISPLAY && eglInitialize(display_, &major, &minor), "eglInitialize");
  require(eglBindAPI(EGL_OPENGL_API), "eglBindAPI");
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig configuration = nullptr;
  eglChooseConfig(display_, wanted, &configuration, 1, &configurations);
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  context_ = eglCreateContext(display_, configurations > 0 ? configuration : nullptr, EGL_NO_CONTEXT, version);
  require(context_ != EGL_NO_CONTEXT, "eglCreateContext");
  HeadlessWindow::MakeCurrent();
  SetReadyForRendering(true);
  SetOffScreenRendering(1);
  SetShowWindow(false);
  SetFrameBlitModeToNoBlit();
  SetOwnContext(0);
  SetMapped(1);
}

HeadlessWindow::~HeadlessWindow() {
  Finalize();
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

void HeadlessWindow::MakeCurrent() { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_); }

bool HeadlessWindow::IsCurrent() { return eglGetCurrentContext() == context_; }

void HeadlessWindow::OpenGLInitContext() {
  if (Initialized) return;
  ContextCreationTime.Modified();
  MakeCurrent();
  glewExperimental = GL_TRUE;
  const GLenum result = glewInit();  // Debian's GLEW is of the GLX flavour: it loads all of OpenGL before it misses GLX
  GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
  require(GlewInitValid, "glewInit");
  Initialized = true;
  float widths[2];
  GetState()->vtkglGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
  MaximumHardwareLineWidth = std::max(MaximumHardwareLineWidth, widths[1]);
}

}  // namespace bake
