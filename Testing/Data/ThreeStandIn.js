// Stands for three.js in tests that write pages but do not draw them.
exports.WebGLRenderer = null;
