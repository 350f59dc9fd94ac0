@echo off
rem SimpleRay on Windows. It needs Java 17 or later, and build\libs\simpleray.jar, which gradlew.bat makes.
rem SIMPLERAY_OPTS holds options for the JVM.
setlocal DisableDelayedExpansion

set "jar=%~dp0build\libs\simpleray.jar"
if not exist "%jar%" goto nojar

set "java="
if defined JAVA_HOME set "java=%JAVA_HOME:"=%\bin\java.exe"
if not defined java for %%i in (java.exe) do set "java=%%~$PATH:i"
if not defined java goto nojava
if not exist "%java%" goto nojava

set "options=-XX:-UsePerfData"
if "%~1"=="render" set "options=%options% -XX:+UseSerialGC -XX:NewRatio=4 -XX:MinHeapFreeRatio=10 -XX:MaxHeapFreeRatio=25"
"%java%" %options% %SIMPLERAY_OPTS% -jar "%jar%" %*
set "code=%ERRORLEVEL%"
if not "%code%"=="1" exit /b %code%

rem 1 is what verify and compare say of pictures that differ, and what a Java says that is too old or does not start.
"%java%" %options% %SIMPLERAY_OPTS% --dry-run -jar "%jar%" >nul 2>&1
if not errorlevel 1 exit /b 1
>&2 echo simpleray: "%java%" does not start the program: Java 17 or later is needed
exit /b 70

:nojar
>&2 echo simpleray: there is no "%jar%": make it by "%~dp0gradlew.bat" jar
exit /b 70

:nojava
>&2 echo simpleray: no Java 17 or later: install it, and let JAVA_HOME or PATH lead to it
exit /b 70
