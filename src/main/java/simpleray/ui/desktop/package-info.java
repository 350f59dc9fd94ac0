/** What users of a desktop expect: file dialogs, recent scenes, the clipboard, looks, help, and a window that is where it was. */
package simpleray.ui.desktop;
