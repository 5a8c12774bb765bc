angle increment: 45
initial line width: 0.9
initial color: 1
tropism direction: 0,1,0
contour: 1 calla_stalk.con
contour sides: 12
material: 1 stalk kind=stem color=0.36,0.50,0.20 roughness=0.55
material: 2 blade kind=leaf color=0.16,0.36,0.13 roughness=0.4 translucency=0.35
material: 3 spathe kind=petal color=0.97,0.96,0.90 roughness=0.45 translucency=0.4
material: 4 spadix kind=solid color=0.95,0.78,0.16 roughness=0.8
surface: l calla_blade.s 10
surface: s calla_spathe.s 8
organ: k spadix kind=ball material=4 length=5.2 width=0.85
