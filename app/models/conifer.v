angle increment: 45
initial line width: 1
initial color: 1
tropism direction: 0,1,0
initial elasticity: 0.02
radii: pipe 2.2 0.14
material: 1 bark kind=bark bark=spruce color=0.38,0.30,0.25 roughness=1
material: 2 needle kind=leaf color=0.15,0.30,0.17 roughness=0.6 translucency=0.1
organ: n needle kind=needle material=2 length=5.2 width=0.72 curl=14
